#include "event.hpp"

#include "keys.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <prelight/error.hpp>

namespace prelight::app::viewer {
namespace {

constexpr auto all_verbs = std::to_array<Verb>({
    {"key", "kd", "a key goes down or up"},
    {"button", "bdnn", "a button of the mouse, at x, y in pixels from the top left"},
    {"move", "nn", "the mouse is at x, y"},
    {"wheel", "nn", "sideways, and forward, in notches"},
    {"leave", "", "the window has lost the keyboard: nothing is held down any more"},
    {"drop", "t", "a file fell into the window: a scene, or an environment"},
    {"resize", "cc", "the window's size in pixels; 0 0: minimised"},
    {"scale", "n", "pixels that are drawn for one of the window's, along each side"},
    {"renderer", "t", "another renderer"},
    {"preset", "t", "another preset; empty: none"},
    {"set", "tt", "a setting of the renderer"},
    {"unset", "t", "a setting goes back to its default"},
    {"shading", "t", "ggx or phong; empty: the preset's own"},
    {"tonemap", "t", "pbr-neutral, aces or none"},
    {"exposure", "n", "EV"},
    {"buffer", "t", "which buffer is shown"},
    {"camera", "t", "one of the scene's cameras, by name or index"},
    {"frame", "", "the camera sees all of the scene"},
    {"play", "s", "animations"},
    {"time", "n", "seconds from the animations' start"},
    {"speed", "n", "seconds of the animations in one second"},
    {"animation", "t", "name or index; empty: all"},
    {"turn-camera", "s", "the camera goes round"},
    {"turn-objects", "s", "objects turn"},
    {"turn-lights", "s", "lights go round"},
    {"cycle-materials", "", "the selected object, or all, take the scene's next material"},
    {"select-light", "c", "by its number"},
    {"select-object", "c", "by the number of its node"},
    {"select-none", "", "nothing is selected"},
    {"pick-light", "nn", "the light that shows nearest to x, y; once more: the next"},
    {"pick-object", "nn", "what is seen at x, y"},
    {"move-light", "cnnn", "by metres, world"},
    {"move-object", "cnnn", "by metres, world"},
    {"light-colour", "cnnn", "linear RGB"},
    {"light-intensity", "cn", "candela or lux"},
    {"light-range", "cn", "metres; 0: without end"},
    {"add-light", "", "a point light where the camera looks"},
    {"remove-light", "c", "by its number"},
    {"remove-selected", "", "the selected light"},
    {"random-lights", "", "colours and intensities of all lights"},
    {"only-selected", "s", "the selected light shines alone"},
    {"reload", "", "the scene and what belongs to it are read again"},
    {"screenshot", "t", "writes the picture to a .png; empty: prelight-N.png, the next one that is free"},
    {"help", "s", "the list of keys"},
    {"panels", "s", "all panels"},
    {"lose", "p", "a test's: the device or the surface is lost now"},
    {"quit", "", "the end"},
});

std::optional<double> number_of(std::string_view text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !(std::abs(value) <= largest_number))
        return {};
    return value;
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::ranges::find(words, word) != words.end();
}

/// What is wrong with a word; empty: nothing.
std::string_view fault(char kind, const std::string& word) {
    switch (kind) {
    case 't': return word.size() <= 4096 ? "" : "is too long";
    case 'n': return number_of(word) ? "" : "is not a number within ±1e9";
    case 'c': {
        const auto number = number_of(word);
        return number && *number >= 0 && std::floor(*number) == *number ? "" : "is not a whole number from 0 to 1e9";
    }
    case 's': return is_one_of(word, {"on", "off", "toggle"}) ? "" : "is not on, off or toggle";
    case 'k': return is_key(word) ? "" : "is not a key";
    case 'd': return is_one_of(word, {"down", "up"}) ? "" : "is neither down nor up";
    case 'b': return is_one_of(word, {"left", "middle", "right"}) ? "" : "is not left, middle or right";
    default: return is_one_of(word, {"device", "surface"}) ? "" : "is neither device nor surface";
    }
}

std::string quoted(const std::string& word) {
    if (!word.empty() && word.find_first_of(" \"\\\n") == std::string::npos)
        return word;
    std::string out = "\"";
    for (const char c : word) {
        if (c == '"' || c == '\\')
            out += '\\';
        if (c == '\n')
            out += "\\n";
        else
            out += c;
    }
    return out + "\"";
}

std::vector<std::string> split(std::string_view line) {
    std::vector<std::string> words;
    size_t i = 0;
    while (i < line.size()) {
        if (line[i] == ' ') {
            ++i;
            continue;
        }
        std::string& word = words.emplace_back();
        if (line[i] != '"') {
            while (i < line.size() && line[i] != ' ')
                word += line[i++];
            continue;
        }
        for (++i; i < line.size() && line[i] != '"'; ++i) {
            const bool escaped_one = line[i] == '\\' && i + 1 < line.size();
            i += escaped_one;
            word += escaped_one && line[i] == 'n' ? '\n' : line[i];
        }
        if (i == line.size())
            throw Error("a quotation mark is not closed");
        ++i;
        if (i < line.size() && line[i] != ' ')
            throw Error("something follows a closing quotation mark");
    }
    return words;
}

} // namespace

double Event::number(size_t i) const { return number_of(words.at(i)).value(); }

bool Event::turned(size_t i, bool now) const { return words.at(i) == "toggle" ? !now : words.at(i) == "on"; }

std::span<const Verb> verbs() { return all_verbs; }

void check_event(const Event& event) {
    const auto verb = std::ranges::find(all_verbs, std::string_view(event.verb), &Verb::name);
    if (verb == all_verbs.end())
        throw Error(fmt::format("{}: not an event", event.verb));
    if (event.words.size() != verb->arguments.size())
        throw Error(
            fmt::format("{}: has {} arguments, and {} came", event.verb, verb->arguments.size(), event.words.size()));
    for (size_t i = 0; i < event.words.size(); ++i)
        if (const std::string_view wrong = fault(verb->arguments[i], event.words[i]); !wrong.empty())
            throw Error(fmt::format("{}: {} {}", event.verb, event.words[i].substr(0, 80), wrong));
    if (event.verb == "resize" && std::max(event.number(0), event.number(1)) > largest_side)
        throw Error(fmt::format("resize: more than {} pixels a side", largest_side));
}

std::string event_line(const Event& event) {
    std::string line = fmt::format("{} {}", event.step, event.verb);
    for (const std::string& word : event.words)
        line += " " + quoted(word);
    return line;
}

Event parse_event(std::string_view line) {
    std::vector<std::string> words = split(line);
    if (words.size() < 2)
        throw Error("not STEP EVENT …");
    Event event;
    const auto [end, error] = std::from_chars(words[0].data(), words[0].data() + words[0].size(), event.step);
    if (error != std::errc() || end != words[0].data() + words[0].size())
        throw Error(fmt::format("{}: not the number of a step", words[0].substr(0, 80)));
    event.verb = words[1];
    event.words.assign(std::make_move_iterator(words.begin() + 2), std::make_move_iterator(words.end()));
    check_event(event);
    return event;
}

} // namespace prelight::app::viewer

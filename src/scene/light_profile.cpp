// Reads IES files: ANSI/IESNA LM-63, which is lines of keywords up to "TILT=", then numbers wherever a line ends.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <platform/read_file.hpp>
#include <prelight/error.hpp>
#include <prelight/light_distribution.hpp>

namespace prelight {
namespace {

/// A twentieth of a degree around, and no more values than a twentieth by a sixth.
constexpr size_t most_angles = 7201, most_values = size_t(1) << 23;

/// Fit for a message of one line.
std::string shown(std::string_view text) {
    std::string out(text.substr(0, 40));
    for (char& c : out)
        if (static_cast<unsigned char>(c) < 32 || c == 127)
            c = '?';
    return text.size() > 40 ? out + "…" : out;
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r\n\f\v";
    const size_t first = text.find_first_not_of(blank);
    return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(blank) - first + 1);
}

class Reader {
public:
    Reader(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

    [[noreturn]] void fail(const std::string& reason) const {
        throw Error(fmt::format("{}: line {}: {}", name_, line_, reason));
    }
    /// The next line without its end; nothing at the file's end.
    std::optional<std::string_view> line() {
        if (rest_.empty())
            return {};
        ++line_;
        const size_t end = rest_.find('\n');
        const std::string_view taken = rest_.substr(0, end);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        return trimmed(taken);
    }
    double number(std::string_view what) {
        const std::optional<std::string_view> word = next_word();
        if (!word)
            fail(fmt::format("the file ends before {}", what));
        std::string_view digits = *word;
        if (digits.starts_with('+'))
            digits.remove_prefix(1);
        double value = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value))
            fail(fmt::format("{}: \"{}\" is no number", what, shown(*word)));
        return value;
    }
    size_t count(std::string_view what, size_t least, size_t most) {
        const double value = number(what);
        if (value != std::floor(value) || value < double(least) || value > double(most))
            fail(fmt::format("{}: {} is not one of {} … {}", what, value, least, most));
        return static_cast<size_t>(value);
    }
    double positive(std::string_view what) {
        const double value = number(what);
        if (!(value > 0))
            fail(fmt::format("{}: {} is not above 0", what, value));
        return value;
    }
    std::vector<double> ascending(std::string_view what, size_t count) {
        std::vector<double> values;
        for (size_t i = 0; i < count; ++i) {
            const double value = number(what);
            if (i > 0 && !(value > values.back()))
                fail(fmt::format("{}: {} after {} does not ascend", what, value, values.back()));
            values.push_back(value);
        }
        return values;
    }
    void end() {
        if (const auto word = next_word())
            fail(fmt::format("\"{}\" comes after the last candela: there are more values than the angles ask for",
                             shown(*word)));
    }

private:
    /// Words end at blanks, commas, and the sign with which DOS ended files.
    std::optional<std::string_view> next_word() {
        constexpr std::string_view between = " \t\r\f\v,\x1a";
        for (;;) {
            const size_t first = words_.find_first_not_of(between);
            if (first != std::string_view::npos) {
                words_.remove_prefix(first);
                const std::string_view word = words_.substr(0, words_.find_first_of(between));
                words_.remove_prefix(word.size());
                return word;
            }
            const auto next = line();
            if (!next)
                return {};
            words_ = *next;
        }
    }
    std::string_view rest_, words_;
    const std::string& name_;
    size_t line_ = 0;
};

/// Whatever stands before the numbers. True: TILT=INCLUDE.
bool read_head(Reader& reader) {
    constexpr std::string_view versions[] = {"IESNA86", "IESNA91", "IESNA:LM-63-1995", "IESNA:LM-63-2002",
                                             "IES:LM-63-2019"};
    bool first = true;
    while (const auto line = reader.line()) {
        if (line->find('\0') != std::string_view::npos)
            reader.fail("is not text: no LM-63 file");
        if (first && line->starts_with("IES") &&
            std::find(std::begin(versions), std::end(versions), *line) == std::end(versions))
            reader.fail(fmt::format("version \"{}\" is not read (1986, 1991, 1995, 2002 and 2019 are)", shown(*line)));
        first = false;
        if (line->starts_with("[BLOCK]"))
            reader.fail("[BLOCK]: several lamps in one file are not read");
        if (!line->starts_with("TILT="))
            continue;
        const std::string_view tilt = trimmed(line->substr(5));
        if (tilt != "NONE" && tilt != "INCLUDE")
            reader.fail(fmt::format("TILT={}: factors in a file of their own are not read", shown(tilt)));
        return tilt == "INCLUDE";
    }
    reader.fail("there is no TILT= line: no LM-63 file");
}

void pass_over_tilt(Reader& reader) {
    reader.count("the lamp's place (1, 2 or 3)", 1, 3);
    const size_t pairs = reader.count("number of tilt angles", 1, most_angles);
    reader.ascending("tilt angle", pairs);
    for (size_t i = 0; i < pairs; ++i)
        if (reader.number("tilt factor") < 0)
            reader.fail("a tilt factor is negative");
}

/// Horizontal angles all the way round, each with the number of the column that holds its candela.
std::vector<std::pair<double, size_t>> all_round(const Reader& reader, const std::vector<double>& angles) {
    const double first = angles.front(), last = angles.back();
    std::vector<std::pair<double, size_t>> round;
    const auto add = [&](double angle, size_t column) { round.emplace_back(std::fmod(angle + 360, 360.0), column); };
    const bool sides = first == 90 && last == 270; // alike on both sides of the plane 90° – 270°
    if (!sides && (first != 0 || (last != 0 && last != 90 && !(last >= 180 && last <= 360))))
        reader.fail(
            fmt::format("horizontal angles {} … {}: no symmetry is known for that (0 alone, 0 … 90, 0 … 180, 0 … 360, "
                        "90 … 270)",
                        first, last));
    for (size_t i = 0; i < angles.size(); ++i) {
        const double angle = angles[i];
        add(angle, i);
        if (sides)
            add(180 - angle, i);
        else if (last == 90 || last == 180)
            add(-angle, i);
        if (last == 90) {
            add(180 - angle, i);
            add(180 + angle, i);
        }
    }
    std::stable_sort(round.begin(), round.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    round.erase(
        std::unique(round.begin(), round.end(), [](const auto& a, const auto& b) { return a.first == b.first; }),
        round.end());
    return round;
}

} // namespace

LightProfile parse_profile(std::string_view text, const std::string& name) {
    if (text.size() > largest_file::light_profile)
        throw Error(fmt::format("{}: {} bytes are more than an IES file may have ({})", name, text.size(),
                                largest_file::light_profile));
    Reader reader(text, name);
    if (read_head(reader))
        pass_over_tilt(reader);
    reader.count("number of lamps", 0, 1'000'000);
    reader.number("lumens a lamp");
    double factor = reader.positive("candela multiplier");
    const size_t rows = reader.count("number of vertical angles", 2, most_angles);
    const size_t columns = reader.count("number of horizontal angles", 1, most_angles);
    if (rows * columns > most_values)
        reader.fail(fmt::format("{} × {} angles are more than are read ({} values)", rows, columns, most_values));
    const size_t type = reader.count("photometric type", 1, 3);
    if (type != 1)
        reader.fail(fmt::format("photometric type {} ({}) is not read, only type C (1)", type, type == 2 ? "B" : "A"));
    reader.count("unit of length (1 feet, 2 metres)", 1, 2);
    for (const char* size : {"width", "length", "height"})
        reader.number(size); // of the luminaire; negative: round
    factor *= reader.positive("ballast factor");
    factor *= reader.positive("ballast-lamp factor");
    reader.number("input watts");

    LightProfile profile{.name = name, .text = std::string(text), .vertical = {}, .horizontal = {}, .candela = {}};
    profile.vertical = reader.ascending("vertical angle", rows);
    if (profile.vertical.front() < 0 || profile.vertical.back() > 180)
        reader.fail(fmt::format("vertical angles {} … {} are not within 0 … 180", profile.vertical.front(),
                                profile.vertical.back()));
    const auto round = all_round(reader, reader.ascending("horizontal angle", columns));
    std::vector<double> values;
    for (size_t i = 0; i < rows * columns; ++i) {
        const double value = reader.number("candela");
        if (value < 0)
            reader.fail(fmt::format("candela {} is negative", value));
        if (!std::isfinite(static_cast<float>(value * factor)))
            reader.fail(fmt::format("candela {} times the file's factors is too large", value));
        values.push_back(value * factor);
        profile.largest = std::max(profile.largest, values.back());
    }
    reader.end();
    if (!(static_cast<float>(profile.largest) > 0))
        reader.fail("all candela are 0: no light");
    for (const auto& [angle, column] : round) {
        profile.horizontal.push_back(angle);
        const auto begin = values.begin() + static_cast<ptrdiff_t>(column * rows);
        profile.candela.insert(profile.candela.end(), begin, begin + static_cast<ptrdiff_t>(rows));
    }
    return profile;
}

LightProfile load_profile(const std::filesystem::path& path) {
    return parse_profile(read_text_file(path, largest_file::light_profile), path.string());
}

} // namespace prelight

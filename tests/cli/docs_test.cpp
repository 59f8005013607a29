// Every command of README and docs is one that the program takes, down to its settings. Links and figures are held by
// scripts/check_docs.py.
#include <command_line.hpp>
#include <fstream>
#include <gmock/gmock.h>
#include <prelight/error.hpp>
#include <regex>
#include <renderers/settings/settings.hpp>
#include <set>

namespace prelight::test {
namespace {

namespace fs = std::filesystem;

struct Line {
    std::string place;   ///< "docs/bench.md:12"
    std::string command; ///< from the word "prelight" on
};

/// The program's commands in the page's code: blocks, spans that begin with it, and the commands of its figures.
std::vector<Line> commands_of(const fs::path& page) {
    static const std::regex block("^ {4,}(?:\\S*/)?(prelight [a-z].*)$"), span("`(prelight [^`]+)`"),
        figure("<!-- figures \\w+: (prelight .*) -->");
    std::vector<Line> commands;
    std::ifstream stream(page);
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
        const std::string place = page.filename().string() + ":" + std::to_string(++number);
        std::smatch match;
        if (std::regex_search(line, match, block) || std::regex_search(line, match, figure))
            commands.push_back({place, match[1]});
        for (std::sregex_iterator it(line.begin(), line.end(), span), end; it != end; ++it)
            commands.push_back({place, (*it)[1]});
    }
    return commands;
}

/// What stands for something of the reader's own, as the pages write it.
std::string filled_in(const std::string& word) {
    static const std::map<std::string, std::string> meanings{
        {"SCENE", "city"},    {"S", "city"},       {"N", "16"},           {"WxH", "64x36"},   {"R", "deferred"},
        {"W", "tiles"},       {"C", "tiles"},      {"T", "16"},           {"L", "grid"},      {"FILE", "a.json"},
        {"PICTURE", "a.png"}, {"STATS", "a.json"}, {"COMMAND", "render"}, {"TOPIC", "scenes"}};
    const size_t equals = word.rfind('=');
    const std::string last = equals == std::string::npos ? word : word.substr(equals + 1);
    const auto found = meanings.find(last);
    return found == meanings.end() ? word : word.substr(0, word.size() - last.size()) + found->second;
}

std::vector<std::string> words_of(std::string command) {
    command = command.substr(0, command.find(" # "));
    command = std::regex_replace(command, std::regex("[\\[\\]]"), ""); // what may be left out, too
    std::istringstream stream(command);
    std::vector<std::string> words;
    static const std::set<std::string> ends{"|", "&&", ";", "<", ">"};
    for (std::string word; stream >> word && !ends.contains(word);) {
        std::erase(word, '\'');
        words.push_back(filled_in(word));
    }
    return words;
}

/// A sentence that names a part of a command ("`prelight render`") or leaves a part out is no command to run.
bool whole(const std::string& command) {
    static const std::regex bare("prelight [a-z-]+( (report|SCENE))?");
    return command.find("…") == std::string::npos && command.find("...") == std::string::npos &&
           !std::regex_match(command, bare);
}

void check(const app::RenderCommand& command) {
    for (const RendererInfo& info : renderer_infos())
        if (info.name == command.renderer)
            return void(Settings(info, command.options));
    throw UsageError(command.renderer + ": no such renderer");
}
void check(const app::SequenceCommand& command) { check(command.render); }
template <class Other>
void check(const Other&) {}

TEST(Docs, EveryCommandIsOneThatTheProgramTakes) {
    std::vector<fs::path> pages{PRELIGHT_SOURCE_DIR "/README.md", PRELIGHT_SOURCE_DIR "/OVERVIEW.md"};
    for (const auto& entry : fs::recursive_directory_iterator(PRELIGHT_SOURCE_DIR "/docs"))
        if (entry.path().extension() == ".md")
            pages.push_back(entry.path());
    size_t checked = 0;
    for (const fs::path& page : pages)
        for (const Line& line : commands_of(page)) {
            if (!whole(line.command))
                continue;
            const std::vector<std::string> words = words_of(line.command);
            std::vector<const char*> argv;
            for (const std::string& word : words)
                argv.push_back(word.c_str());
            try {
                std::visit([](const auto& command) { check(command); },
                           app::parse_command_line(static_cast<int>(argv.size()), argv.data()));
                ++checked;
            } catch (const UsageError& error) {
                ADD_FAILURE() << line.place << ": " << line.command << "\n" << error.what();
            }
        }
    EXPECT_GT(checked, 80u);
}

} // namespace
} // namespace prelight::test

#pragma once
#include "option_table.hpp"

#include <map>
#include <optional>

namespace prelight::app {

/// What a command was given: options by their long names ("--output"), arguments without one by theirs ("SCENE"), as
/// text, in the order in which they were typed. Nothing is checked but that the option is the command's, and that one
/// that is not repeatable is given once.
class Given {
public:
    explicit Given(const CommandRow& command) : command_(&command) {}

    bool has(std::string_view name) const;
    /// The value of an option; `otherwise` without it.
    std::string text(std::string_view name, std::string_view otherwise = {}) const;
    /// All values of one that is repeatable.
    const std::vector<std::string>& all(std::string_view name) const;
    const CommandRow& command() const { return *command_; }

    /// Throws UsageError naming an option that goes with other bits than `bit` of the command only. `meaning` gives a
    /// mask of bits its name, as in "goes with bench SCENE only".
    void check_bit(uint32_t bit, const std::map<uint32_t, std::string>& meaning) const;

private:
    friend std::optional<Given> parse_arguments(const CommandRow&, const std::vector<std::string>&);
    const CommandRow* command_;
    std::map<std::string, std::vector<std::string>, std::less<>> values_;
};

/// Sorts what follows the command's name. Nothing: help was asked for. Throws UsageError, naming first what of the
/// options is unknown, in the order in which they were typed.
std::optional<Given> parse_arguments(const CommandRow& command, const std::vector<std::string>& arguments);

} // namespace prelight::app

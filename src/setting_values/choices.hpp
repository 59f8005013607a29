#pragma once
#include <prelight/error.hpp>
#include <prelight/renderer.hpp>
#include <span>
#include <string>
#include <string_view>

namespace prelight {

/// One word that a setting may have, and what it means to the code.
template <class T>
struct Choice {
    std::string_view word;
    T value;
};

/// A setting that is one of an enum's values: the one table from which its words are listed, checked and understood.
template <class T>
struct ChoiceSetting {
    const char* key;
    std::span<const Choice<T>> choices;
    std::string_view default_word; ///< one of them, or "auto"
    const char* description;
    bool automatic = false; ///< "auto" is a word too, before the others: somebody resolves it before value() is asked

    SettingInfo info() const {
        SettingInfo out{key, {}, std::string(default_word), description};
        if (automatic)
            out.values.emplace_back("auto");
        for (const Choice<T>& choice : choices)
            out.values.emplace_back(choice.word);
        return out;
    }
    /// Throws Error for a word that is not in the table: a setting that nobody has resolved.
    T value(std::string_view word) const {
        for (const Choice<T>& choice : choices)
            if (choice.word == word)
                return choice.value;
        throw Error(std::string(key) + "=" + std::string(word) + ": was not resolved");
    }
    std::string word(T value) const {
        for (const Choice<T>& choice : choices)
            if (choice.value == value)
                return std::string(choice.word);
        throw Error(std::string(key) + ": a value without a word");
    }
};

} // namespace prelight

#include "app/cli/arguments.h"

#include <charconv>

namespace mw::cli {

namespace {

bool looksLikeOption(std::string_view word)
{
    return word.size() > 1 && word[0] == '-';
}

}  // namespace

Arguments::Arguments(std::span<char* const> words)
{
    bool literal = false;
    for (const char* w : words) {
        if (!literal && std::string_view(w) == "--") {
            literal = true;
            continue;
        }
        words_.push_back({w, literal});
    }
}

bool Arguments::flag(std::string_view name, std::string_view shortName)
{
    return std::erase_if(words_, [&](const Word& w) { return !w.literal && (w.text == name || (!shortName.empty() && w.text == shortName)); }) > 0;
}

std::vector<std::pair<std::string, std::string>> Arguments::inOrder(std::span<const std::string_view> names)
{
    std::vector<std::pair<std::string, std::string>> found;
    const auto take = [&](size_t i) -> size_t {  // words that the option at i takes; 0: it is none
        const std::string w = words_[i].text;
        for (const std::string_view name : names) {
            if (words_[i].literal || name.empty() || !w.starts_with(name)) continue;
            if (name.starts_with("--") && w.size() > name.size() && w[name.size()] == '=') {
                found.emplace_back(name, w.substr(name.size() + 1));
                return 1;
            }
            if (w != name) continue;
            // A number may start with a minus sign; another option's name may not stand here.
            if (i + 1 >= words_.size() || words_[i + 1].literal || words_[i + 1].text.starts_with("--")) throw UsageError(w + " wants a value");
            found.emplace_back(name, words_[i + 1].text);
            return 2;
        }
        return 0;
    };
    for (size_t i = 0; i < words_.size();) {
        const size_t taken = take(i);
        words_.erase(words_.begin() + long(i), words_.begin() + long(i + taken));
        i += taken == 0;
    }
    return found;
}

std::vector<std::string> Arguments::values(std::string_view name, std::string_view shortName)
{
    const std::string_view names[] = {name, shortName};
    std::vector<std::string> found;
    for (auto& option : inOrder(names)) found.push_back(std::move(option.second));
    return found;
}

std::optional<std::string> Arguments::value(std::string_view name, std::string_view shortName)
{
    std::vector<std::string> all = values(name, shortName);
    if (all.size() > 1) throw UsageError(std::string(shortName.empty() ? name : shortName) + " may be given once only");
    if (all.empty()) return {};
    return std::move(all.front());
}

std::optional<long> Arguments::number(std::string_view name, long min, long max)
{
    const std::optional<std::string> text = value(name);
    if (!text) return {};
    long n = 0;
    const auto [end, failure] = std::from_chars(text->data(), text->data() + text->size(), n);
    if (failure != std::errc() || end != text->data() + text->size() || n < min || n > max)
        throw UsageError(std::string(name) + " wants a whole number from " + std::to_string(min) + " to " + std::to_string(max) + ", not '" + *text +
                         "'");
    return n;
}

std::vector<std::string> Arguments::finish(std::span<const std::string_view> names)
{
    std::vector<std::string> positional;
    for (Word& w : words_) {
        if (!w.literal && looksLikeOption(w.text)) throw UsageError("unknown option '" + w.text + "'");
        positional.push_back(std::move(w.text));
    }
    words_.clear();
    if (positional.size() < names.size()) throw UsageError(std::string(names[positional.size()]) + " is missing");
    if (positional.size() > names.size()) throw UsageError("'" + positional[names.size()] + "' is one argument too many");
    for (size_t i = 0; i < names.size(); ++i)
        if (positional[i].empty()) throw UsageError(std::string(names[i]) + " is empty");
    return positional;
}

}  // namespace mw::cli

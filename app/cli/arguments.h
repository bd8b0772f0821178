// The words after a verb. A verb takes the options it knows by name; what is then left over is wrong usage.
#pragma once
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mw::cli {

/// The command was given wrongly: message and usage go to standard error, the exit status is 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Options may stand anywhere; `--` ends them; `--name=value` and `--name value` are the same; a lone `-` is no option.
class Arguments {
public:
    explicit Arguments(std::span<char* const> words);

    /// True when the flag is there. `shortName` as in "-h", may be empty.
    bool flag(std::string_view name, std::string_view shortName = {});
    /// The value of an option. Throws UsageError when the value is missing or the option is there twice.
    std::optional<std::string> value(std::string_view name, std::string_view shortName = {});
    /// All values of an option that may be repeated, in order.
    std::vector<std::string> values(std::string_view name, std::string_view shortName = {});
    /// All values of options that may be repeated, in the order of the command line: name and value.
    std::vector<std::pair<std::string, std::string>> inOrder(std::span<const std::string_view> names);
    /// A whole number within a range.
    std::optional<long> number(std::string_view name, long min, long max);

    /// What is no option, once all options were taken. Throws UsageError on an option nobody took, or on another count than wanted:
    /// `names` says what each one is ("FILE").
    std::vector<std::string> finish(std::span<const std::string_view> names);
    std::vector<std::string> finish(std::initializer_list<std::string_view> names) { return finish(std::span(names.begin(), names.size())); }

private:
    struct Word {
        std::string text;
        bool literal = false;  // after "--": never an option
    };
    std::vector<Word> words_;
};

}  // namespace mw::cli

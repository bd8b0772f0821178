// Reading JSON with the place at hand: every complaint about a glTF names its JSON pointer ("/accessors/3/count").
#pragma once
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/error.h"

namespace mw {

/// A value of a JSON document and where it is. Every access checks the type; what does not fit throws Error.
class JsonPlace {
public:
    JsonPlace(const nlohmann::json& value, std::string pointer) : value_(&value), pointer_(std::move(pointer)) {}

    const nlohmann::json& value() const { return *value_; }
    const std::string& pointer() const { return pointer_; }
    [[noreturn]] void fail(const std::string& what) const { throw Error((pointer_.empty() ? "/" : pointer_) + ": " + what); }

    std::optional<JsonPlace> find(const char* key) const
    {
        if (!value_->is_object()) fail("must be an object, not " + typeName());
        const auto i = value_->find(key);
        if (i == value_->end()) return std::nullopt;
        return JsonPlace(*i, pointer_ + "/" + key);
    }
    bool has(const char* key) const { return find(key).has_value(); }
    JsonPlace operator[](const char* key) const
    {
        auto found = find(key);
        if (!found) fail(std::string("\"") + key + "\" is missing");
        return *found;
    }
    /// Of an array.
    size_t size() const
    {
        if (!value_->is_array()) fail("must be an array, not " + typeName());
        return value_->size();
    }
    JsonPlace operator[](size_t i) const
    {
        if (i >= size()) fail("has only " + std::to_string(size()) + " entries");
        return {(*value_)[i], pointer_ + "/" + std::to_string(i)};
    }
    /// Entries of the array `key`; 0 when it is not there.
    size_t sizeOf(const char* key) const
    {
        const auto found = find(key);
        return found ? found->size() : 0;
    }

    double number() const
    {
        if (!value_->is_number()) fail("must be a number, not " + typeName());
        return value_->get<double>();
    }
    /// A whole number from 0 to 2^53.
    uint64_t whole() const
    {
        if (value_->is_number_unsigned() && value_->get<uint64_t>() <= largestWhole) return value_->get<uint64_t>();
        const double d = number();
        if (!(d >= 0) || d > double(largestWhole) || d != std::floor(d)) fail("must be a whole number of at least 0, not " + value_->dump());
        return uint64_t(d);
    }
    /// An index into `count` things called `of`.
    uint32_t index(size_t count, const char* of) const
    {
        const uint64_t i = whole();
        if (i >= count)
            fail("names " + std::string(of) + " " + std::to_string(i) + ", but there are " + std::to_string(count) + "; the file is damaged");
        return uint32_t(i);
    }
    const std::string& text() const
    {
        if (!value_->is_string()) fail("must be a text, not " + typeName());
        return value_->get_ref<const std::string&>();
    }
    bool flag() const
    {
        if (!value_->is_boolean()) fail("must be true or false, not " + typeName());
        return value_->get<bool>();
    }

    double number(const char* key, double initial) const
    {
        const auto v = find(key);
        return v ? v->number() : initial;
    }
    uint64_t whole(const char* key, uint64_t initial) const
    {
        const auto v = find(key);
        return v ? v->whole() : initial;
    }
    std::string text(const char* key) const
    {
        const auto v = find(key);
        return v ? v->text() : std::string();
    }
    bool flag(const char* key, bool initial) const
    {
        const auto v = find(key);
        return v ? v->flag() : initial;
    }
    std::optional<uint32_t> index(const char* key, size_t count, const char* of) const
    {
        const auto v = find(key);
        return v ? std::optional(v->index(count, of)) : std::nullopt;
    }
    /// Exactly N numbers into `to[0..N-1]`, which stays as it is when the key is not there.
    template <int N, class Vector>
    void numbers(const char* key, Vector& to) const
    {
        const auto v = find(key);
        if (!v) return;
        if (v->size() != N) v->fail("must have " + std::to_string(N) + " numbers, not " + std::to_string(v->size()));
        for (int i = 0; i < N; ++i) to[i] = (*v)[size_t(i)].number();
    }

private:
    static constexpr uint64_t largestWhole = uint64_t(1) << 53;
    std::string typeName() const { return value_->type_name(); }
    const nlohmann::json* value_;
    std::string pointer_;
};

}  // namespace mw

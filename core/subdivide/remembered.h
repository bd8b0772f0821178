// What a subdivision made last, so that it does only the arithmetic again when nothing but the positions has changed: a vertex is dragged.
#pragma once
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "core/mesh/mesh.h"

namespace mw {

/// All arrays of a mesh but its positions, by identity. Holds none of them: one that is gone equals nothing.
class FaceIdentity {
public:
    explicit FaceIdentity(const Mesh& mesh);
    bool operator==(const FaceIdentity& other) const;
    bool gone() const;

private:
    void add(const void* id, std::weak_ptr<const void> owner);
    template <class T>
    void add(const Shared<T>& a)
    {
        add(a.id(), a.owner());
    }
    std::string names_;
    std::vector<std::pair<const void*, std::weak_ptr<const void>>> arrays_;
};

/// A few results of one operation with their tables, the last used first, within a bound of bytes; those whose input is gone are let go at the next
/// call. Sharing the result's faces also shares what is derived from them, on the graphics card as well.
template <class Tables>
class Remembered {
public:
    struct Made {
        Mesh mesh;
        std::shared_ptr<const Tables> tables;
    };
    std::optional<Made> find(const Mesh& input, const std::string& parameters)
    {
        const FaceIdentity identity(input);
        const std::lock_guard lock(mutex_);
        entries_.remove_if([](const Entry& e) { return e.input.gone(); });
        for (auto i = entries_.begin(); i != entries_.end(); ++i)
            if (i->parameters == parameters && i->input == identity) {
                entries_.splice(entries_.begin(), entries_, i);
                return entries_.front().made;
            }
        return {};
    }
    void keep(const Mesh& input, std::string parameters, Mesh made, Tables tables, size_t bytes)
    {
        const std::lock_guard lock(mutex_);
        if (bytes > mostBytes) return;
        entries_.push_front(
            {FaceIdentity(input), std::move(parameters), {std::move(made), std::make_shared<const Tables>(std::move(tables))}, bytes});
        size_t sum = 0, count = 0;
        entries_.remove_if([&](const Entry& e) { return ++count > most || (sum += e.bytes) > mostBytes; });
    }

private:
    static constexpr size_t most = 4, mostBytes = size_t(512) << 20;
    struct Entry {
        FaceIdentity input;
        std::string parameters;
        Made made;
        size_t bytes;
    };
    std::mutex mutex_;
    std::list<Entry> entries_;
};

}  // namespace mw

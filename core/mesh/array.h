// Immutable shared arrays: what payloads are made of. Identity (the address) tells caches and the graphics card what has changed.
#pragma once
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace mw {

/// Leaves elements uninitialised on resize(n): large buffers are filled once, not zeroed first.
template <class T>
struct UninitialisedAllocator : std::allocator<T> {
    template <class U>
    struct rebind {
        using other = UninitialisedAllocator<U>;
    };
    using std::allocator<T>::allocator;
    template <class U>
    void construct(U* p)
    {
        ::new (static_cast<void*>(p)) U;
    }
    template <class U, class... A>
    void construct(U* p, A&&... a)
    {
        ::new (static_cast<void*>(p)) U(std::forward<A>(a)...);
    }
};

/// A plain growable array. `Array<float> a(n)` is NOT zeroed; `Array<float> a(n, 0.f)` is.
template <class T>
using Array = std::vector<T, UninitialisedAllocator<T>>;

/// An array that nobody changes any more, shared by all copies. Never null; an empty one has no identity.
template <class T>
class Shared {
public:
    Shared() = default;
    Shared(Array<T> a) : data_(a.empty() ? nullptr : std::make_shared<const Array<T>>(std::move(a))) {}
    size_t size() const { return data_ ? data_->size() : 0; }
    bool empty() const { return size() == 0; }
    const T* data() const { return data_ ? data_->data() : nullptr; }
    const T& operator[](size_t i) const { return (*data_)[i]; }
    std::span<const T> span() const { return {data(), size()}; }
    operator std::span<const T>() const { return span(); }
    const T* begin() const { return data(); }
    const T* end() const { return data() + size(); }
    /// Equal for copies of one array; to key caches by. Hold `owner()` to keep the address from being used again.
    const void* id() const { return data_.get(); }
    std::shared_ptr<const void> owner() const { return data_; }
    size_t bytes() const { return size() * sizeof(T); }

private:
    std::shared_ptr<const Array<T>> data_;
};

}  // namespace mw

// Large plain memory for tables that are made once and walked at random: on large pages where the system has them, and not zeroed first.
#pragma once
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>
#ifdef __linux__
#include <sys/mman.h>
#endif

namespace mw {

/// Fewer page faults and address-translation misses than a vector has.
template <class T>
class LargeBuffer {
    static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

public:
    LargeBuffer() = default;
    explicit LargeBuffer(size_t n) { take(n); }

    /// Forgets what was there; the new elements are not initialised.
    void take(size_t n)
    {
        constexpr size_t large = size_t(2) << 20, line = 64;
        const size_t page = n * sizeof(T) >= large ? large : line, bytes = (n * sizeof(T) + page) / page * page;
        data_.reset(static_cast<T*>(std::aligned_alloc(page, bytes)));
        if (!data_) throw std::bad_alloc();
        size_ = n;
#ifdef MADV_HUGEPAGE
        if (page == large) madvise(data_.get(), bytes, MADV_HUGEPAGE);
#endif
    }
    void zero()
    {
        std::memset(static_cast<void*>(data_.get()), 0, size_ * sizeof(T));
    }
    size_t size() const
    {
        return size_;
    }
    T* data()
    {
        return data_.get();
    }
    T& operator[](size_t i)
    {
        return data_.get()[i];
    }
    const T& operator[](size_t i) const
    {
        return data_.get()[i];
    }

private:
    struct Free {
        void operator()(T* p) const { std::free(p); }
    };
    std::unique_ptr<T, Free> data_;
    size_t size_ = 0;
};

}  // namespace mw

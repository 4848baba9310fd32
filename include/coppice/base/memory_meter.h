#pragma once

#include "coppice/export.h"

#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

namespace coppice::inline v0 {

/// Counts the bytes that the arrays of a build hold, and their peak. Code that allocates a large
/// array reports it through MeteredBytes. Builders pass the meter along as a pointer; null disables
/// counting. Safe to use from several threads at once.
class MemoryMeter {
public:
    /// Adds `bytes` to the bytes held, and updates the peak.
    void add(std::uint64_t bytes) noexcept {
        const std::uint64_t held = held_.fetch_add(bytes, std::memory_order_relaxed) + bytes;
        std::uint64_t peak = peak_.load(std::memory_order_relaxed);
        while (held > peak && !peak_.compare_exchange_weak(peak, held, std::memory_order_relaxed)) {
        }
    }

    /// Subtracts `bytes` from the bytes held.
    void remove(std::uint64_t bytes) noexcept { held_.fetch_sub(bytes, std::memory_order_relaxed); }

    /// The number of bytes held now.
    [[nodiscard]] std::uint64_t held_bytes() const noexcept { return held_; }

    /// The greatest number of bytes held at once so far.
    [[nodiscard]] std::uint64_t peak_bytes() const noexcept { return peak_; }

private:
    std::atomic<std::uint64_t> held_{0};
    std::atomic<std::uint64_t> peak_{0};
};

/// Counts the bytes of one array in a MemoryMeter for as long as this object lives. Keep it beside
/// the array: move it and destroy it together with the array. Arrays below `least_bytes` are not
/// counted: there are too many of them to count cheaply, and those alive at any moment are too few
/// to matter.
class MeteredBytes {
public:
    /// Smaller arrays are not counted.
    static constexpr std::uint64_t least_bytes = 4096;

    MeteredBytes() = default;

    /// Counts `bytes` until destruction. `meter` may be null, which disables counting; otherwise it
    /// must outlive this object.
    MeteredBytes(MemoryMeter* meter, std::uint64_t bytes) noexcept
        : meter_(bytes < least_bytes ? nullptr : meter), bytes_(bytes) {
        if (meter_ != nullptr) meter_->add(bytes_);
    }

    /// Counts the current capacity of a vector. Later growth of the vector is not noticed.
    template <typename T>
    MeteredBytes(MemoryMeter* meter, const std::vector<T>& array) noexcept
        : MeteredBytes(meter, std::uint64_t{array.capacity() * sizeof(T)}) {}

    /// Takes over the count of `other`.
    MeteredBytes(MeteredBytes&& other) noexcept
        : meter_(std::exchange(other.meter_, nullptr)), bytes_(other.bytes_) {}

    /// Takes over the count of `other`; the bytes counted before are subtracted.
    MeteredBytes& operator=(MeteredBytes&& other) noexcept {
        std::swap(meter_, other.meter_);
        std::swap(bytes_, other.bytes_);
        other.release();
        return *this;
    }

    MeteredBytes(const MeteredBytes&) = delete;
    MeteredBytes& operator=(const MeteredBytes&) = delete;

    ~MeteredBytes() { release(); }

    /// Stops counting: call it when the array is freed.
    void release() noexcept {
        if (meter_ != nullptr) meter_->remove(bytes_);
        meter_ = nullptr;
    }

private:
    MemoryMeter* meter_ = nullptr;
    std::uint64_t bytes_ = 0;
};

/// The peak memory of this process in bytes, as the system reports it ("VmHWM" on Linux). 0 where
/// the system does not report it.
[[nodiscard]] COPPICE_EXPORT std::uint64_t process_peak_bytes() noexcept;

}  // namespace coppice::inline v0

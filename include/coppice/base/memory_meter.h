#pragma once

#include "coppice/export.h"

#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

namespace coppice::inline v0 {

/// Counts the bytes that the arrays of a build hold, and the most they ever held together. Those
/// who allocate tell it (MeteredBytes); it is passed along by pointer, and without one nothing is
/// counted. May be told from several threads at once.
class MemoryMeter {
public:
    /// So many bytes more are held.
    void add(std::uint64_t bytes) noexcept {
        const std::uint64_t held = held_.fetch_add(bytes, std::memory_order_relaxed) + bytes;
        std::uint64_t peak = peak_.load(std::memory_order_relaxed);
        while (held > peak && !peak_.compare_exchange_weak(peak, held, std::memory_order_relaxed)) {
        }
    }

    /// So many bytes are held no longer.
    void remove(std::uint64_t bytes) noexcept { held_.fetch_sub(bytes, std::memory_order_relaxed); }

    /// Bytes held now.
    [[nodiscard]] std::uint64_t held_bytes() const noexcept { return held_; }

    /// The most bytes held at once so far.
    [[nodiscard]] std::uint64_t peak_bytes() const noexcept { return peak_; }

private:
    std::atomic<std::uint64_t> held_{0};
    std::atomic<std::uint64_t> peak_{0};
};

/// The bytes of one array, counted by a meter for as long as this lives: it is created beside the
/// array, moved with it and dropped with it. Arrays below `least_bytes` are not counted: they are
/// too many to be worth it, and only a few of them, by far too small to matter, live at once.
class MeteredBytes {
public:
    /// What is smaller is not counted.
    static constexpr std::uint64_t least_bytes = 4096;

    MeteredBytes() = default;

    /// Counts `bytes` from now on; the meter may be null, else it must outlive this.
    MeteredBytes(MemoryMeter* meter, std::uint64_t bytes) noexcept
        : meter_(bytes < least_bytes ? nullptr : meter), bytes_(bytes) {
        if (meter_ != nullptr) meter_->add(bytes_);
    }

    /// Counts what a vector has allocated; what it allocates later is not seen.
    template <typename T>
    MeteredBytes(MemoryMeter* meter, const std::vector<T>& array) noexcept
        : MeteredBytes(meter, std::uint64_t{array.capacity() * sizeof(T)}) {}

    /// Takes over what the other one counts.
    MeteredBytes(MeteredBytes&& other) noexcept
        : meter_(std::exchange(other.meter_, nullptr)), bytes_(other.bytes_) {}

    /// Takes over what the other one counts; its own bytes are gone.
    MeteredBytes& operator=(MeteredBytes&& other) noexcept {
        std::swap(meter_, other.meter_);
        std::swap(bytes_, other.bytes_);
        other.release();
        return *this;
    }

    MeteredBytes(const MeteredBytes&) = delete;
    MeteredBytes& operator=(const MeteredBytes&) = delete;

    ~MeteredBytes() { release(); }

    /// The array is gone.
    void release() noexcept {
        if (meter_ != nullptr) meter_->remove(bytes_);
        meter_ = nullptr;
    }

private:
    MemoryMeter* meter_ = nullptr;
    std::uint64_t bytes_ = 0;
};

/// The most memory that this process has held so far, as the system counts it (the "VmHWM" of
/// Linux); 0 where the system does not tell.
[[nodiscard]] COPPICE_EXPORT std::uint64_t process_peak_bytes() noexcept;

}  // namespace coppice::inline v0

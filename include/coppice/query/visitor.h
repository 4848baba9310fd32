#pragma once

#include <concepts>
#include <memory>
#include <type_traits>

namespace coppice::inline v0 {

/// Any callable, also a function, that takes a `const T&`, by reference, for the length of a call:
/// how queries hand over what they find without allocating. A callable that returns a bool ends the
/// query by false. It must not throw: queries are noexcept.
template <typename T>
class Visitor {
public:
    // Implicit by design: a query takes any callable. One by value would be copied, and so would
    // what it counts.
    // NOLINTBEGIN(google-explicit-constructor,bugprone-forwarding-reference-overload)
    /// Refers to a callable, which must outlive the query.
    template <std::invocable<const T&> Visit>
    requires(!std::same_as<std::remove_cvref_t<Visit>, Visitor>) Visitor(Visit&& visit)
    noexcept
        : visit_(const_cast<void*>(reinterpret_cast<const void*>(std::addressof(visit)))),
          call_(&call<std::remove_reference_t<Visit>>) {}

    // NOLINTEND(google-explicit-constructor,bugprone-forwarding-reference-overload)

    /// True if the query is to go on.
    bool operator()(const T& found) const { return call_(visit_, found); }

private:
    template <typename Visit>
    static bool call(void* visit, const T& found) {
        if constexpr (std::is_void_v<std::invoke_result_t<Visit&, const T&>>) {
            (*reinterpret_cast<Visit*>(visit))(found);
            return true;
        } else {
            return (*reinterpret_cast<Visit*>(visit))(found);
        }
    }

    void* visit_;
    bool (*call_)(void*, const T&);
};

}  // namespace coppice::inline v0

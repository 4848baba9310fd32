#pragma once

#include <concepts>
#include <memory>
#include <type_traits>

namespace coppice::inline v0 {

/// A reference to a callable that takes a `const T&`. Queries pass it each result without
/// allocating. A callable that returns bool ends the query by returning false. The callable must
/// not throw, because queries are noexcept.
template <typename T>
class Visitor {
public:
    // Implicit by design: a query accepts any callable. Taken by reference, so that a callable with
    // state is not copied.
    // NOLINTBEGIN(google-explicit-constructor,bugprone-forwarding-reference-overload)
    /// Refers to `visit`, which must outlive the query.
    template <std::invocable<const T&> Visit>
    requires(!std::same_as<std::remove_cvref_t<Visit>, Visitor>) Visitor(Visit&& visit)
    noexcept
        : visit_(const_cast<void*>(reinterpret_cast<const void*>(std::addressof(visit)))),
          call_(&call<std::remove_reference_t<Visit>>) {}

    // NOLINTEND(google-explicit-constructor,bugprone-forwarding-reference-overload)

    /// Calls the callable. Returns true if the query should continue.
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

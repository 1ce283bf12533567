#pragma once

#include <atomic>
#include <mutex>
#include <optional>

namespace blossom {

/// A value that the first thread to need it makes, and that all threads read from then on.
///
/// If making it throws, the next caller tries again. std::call_once does the same, but it needs memory for an
/// exception and ends the process if there is none.
template <class Value>
class MadeOnce {
public:
    /// The value, or nullptr before it is made.
    const Value* if_made() const { return made_.load(std::memory_order_acquire); }

    /// The value, which `make()` returns if it does not exist yet.
    template <class Make>
    const Value& value(const Make& make) const {
        const Value* known = if_made();
        return known ? *known : make_now(make);
    }

private:
    template <class Make>
    [[gnu::noinline]] const Value& make_now(const Make& make) const {
        const std::scoped_lock lock(making_);
        if (!value_) {
            value_.emplace(make());
            made_.store(&*value_, std::memory_order_release);
        }
        return *value_;
    }

    mutable std::mutex making_;
    mutable std::optional<Value> value_;
    mutable std::atomic<const Value*> made_ = nullptr;
};

}  // namespace blossom

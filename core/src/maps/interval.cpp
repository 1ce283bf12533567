#include <blossom/core/maps/interval.hpp>
#include <blossom/rational/error.hpp>

#include <utility>

namespace blossom {

Interval::Interval(Rational a, Rational b) : a_(std::move(a)), b_(std::move(b)) {
    if (a_ == b_) {
        throw Error(ErrorCode::empty_interval, "the interval [" + to_string(a_) + ", " + to_string(b_) +
                                                   "] is empty; its ends must differ");
    }
}

}  // namespace blossom

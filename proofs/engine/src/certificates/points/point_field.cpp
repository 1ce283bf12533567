#include "point_algebra.hpp"

#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>

#include <utility>

namespace blossom::proofs::second {

namespace {

/// A level of the algebra that exists during its lifetime.
class PassingLevel {
public:
    explicit PassingLevel(Algebra& algebra) : algebra_(algebra) {}
    PassingLevel(const PassingLevel&) = delete;
    PassingLevel& operator=(const PassingLevel&) = delete;
    PassingLevel(PassingLevel&&) = delete;
    PassingLevel& operator=(PassingLevel&&) = delete;
    ~PassingLevel() { algebra_.drop_level(); }

private:
    Algebra& algebra_;
};

}  // namespace

// Steele, Lea, Flood: Fast splittable pseudorandom number generators (2014).
std::uint64_t RandomNumbers::next() {
    state_ += 0x9e3779b97f4a7c15ULL;
    std::uint64_t mixed = state_;
    mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9ULL;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebULL;
    return mixed ^ (mixed >> 31);
}

// Mostly integers, which keep exact results short.
Rational RandomNumbers::number() {
    constexpr std::uint64_t choices = std::uint64_t{4} * 46;
    std::uint64_t drawn = below(choices);
    if (drawn / 4 == last_ / 4) drawn = below(choices);
    last_ = drawn;
    const auto size = static_cast<std::int64_t>(drawn / 4) + 2;
    const Rational value(drawn % 2 == 0 ? size : -size);
    return below(8) == 0 ? value / Rational(drawn / 2 % 2 == 0 ? 2 : 3) : value;
}

AlgebraNumber PointField::symbol(const std::string& name) {
    if (watcher_) watcher_(name);
    const auto known = values_.find(name);
    if (known != values_.end()) return known->second;
    if (closed_) throw Error(ErrorCode::missing_field, "the point has no value of " + name);
    order_.push_back(name);
    return values_.emplace(name, random_.number()).first->second;
}

void PointField::set(const std::string& name, Element value) {
    if (values_.insert_or_assign(name, std::move(value)).second) order_.push_back(name);
}

AlgebraNumber PointField::derivative(const std::function<Element(const Element&)>& f, const Element& at,
                                     std::size_t order) {
    if (order == 0) return f(at);
    const AlgebraNumber step = algebra_.adjoin_nilpotent(order + 1);
    const PassingLevel level(algebra_);
    const AlgebraNumber image = f(algebra_.sum(at, step));
    return algebra_.product(algebra_.parts(image)[order], Rational(factorial(order)));
}

// Computes the first coefficients of f near a point. They are those of f if f is a polynomial, which its
// value at another point confirms.
std::vector<AlgebraNumber> PointField::coefficients(const std::function<Element(const Element&)>& f,
                                                    std::size_t degree) {
    const std::size_t level = algebra_.levels();
    const std::size_t inverted_before = algebra_.highest_inverse();
    algebra_.forget_inverses();
    std::vector<Element> found;
    Element near;
    try {
        found = coefficients_near(f, degree, near);
    } catch (const Error& error) {
        if (error.code() != ErrorCode::division_by_zero) throw;
        near = random_.number();
        found = coefficients_near(f, degree, near);
    }
    const bool divides = algebra_.has_inverted(level);
    algebra_.remember_inverse(inverted_before);
    const Element elsewhere = Rational(static_cast<std::int64_t>(random_.below(90)) + 11);
    Element value;
    for (std::size_t i = found.size(); i-- > 0;) value = sum(product(value, elsewhere), found[i]);
    const bool too_high = !found.back().is_zero();
    found.pop_back();
    if (too_high || !algebra_.difference(f(sum(elsewhere, near)), value).is_zero()) {
        if (divides) throw Error(ErrorCode::syntax, "this is no polynomial in its variable");
        throw Error(ErrorCode::degree_too_low,
                    "this polynomial has a degree higher than " + std::to_string(degree));
    }
    if (near.is_zero()) return found;
    // Horner's rule in t - near.
    for (std::size_t first = 0; first + 1 < found.size(); ++first) {
        for (std::size_t i = found.size() - 1; i-- > first;) {
            found[i] = algebra_.difference(found[i], product(near, found[i + 1]));
        }
    }
    return found;
}

std::vector<AlgebraNumber> PointField::coefficients_near(const std::function<Element(const Element&)>& f,
                                                         std::size_t degree, const Element& near) {
    const AlgebraNumber step = algebra_.adjoin_nilpotent(degree + 2);
    const PassingLevel level(algebra_);
    return algebra_.parts(f(sum(near, step)));
}

}  // namespace blossom::proofs::second

#pragma once

#include <blossom/rational/limits.hpp>
#include <blossom/rational/rational.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace blossom::proofs::second {

/// An element of a tower of algebras over Q: its coordinates in the basis of the lowest algebra of the tower
/// that contains it, without trailing zeros. A rational number needs no additional memory.
class AlgebraNumber {
public:
    AlgebraNumber() = default;
    AlgebraNumber(Rational constant)  // NOLINT(google-explicit-constructor): a rational number is one
        : constant_(std::move(constant)) {}
    explicit AlgebraNumber(std::vector<Rational> coordinates);

    bool is_zero() const { return rest_.empty() && constant_.is_zero(); }
    bool is_rational() const { return rest_.empty(); }
    const Rational& constant() const { return constant_; }
    std::size_t size() const { return rest_.size() + 1; }
    const Rational& operator[](std::size_t place) const { return place == 0 ? constant_ : rest_[place - 1]; }
    std::vector<Rational> coordinates() const;

    friend bool operator==(const AlgebraNumber& a, const AlgebraNumber& b) = default;

private:
    friend class Algebra;

    Rational constant_;
    std::vector<Rational> rest_;
};

/// Q with generators adjoined one after the other. The basis of a level is the basis of the level below times
/// 1, w, ..., w^(d-1), so that elements without w keep their coordinates.
class Algebra {
public:
    explicit Algebra(const Limits& limits) : limits_(limits) {}

    /// Adjoins w with w^degree == 0.
    AlgebraNumber adjoin_nilpotent(std::size_t degree);
    /// Adjoins `count` generators whose products are all zero.
    std::vector<AlgebraNumber> adjoin_first_order(std::size_t count);
    /// Adjoins a root w of w^d + c_(d-1) w^(d-1) + ... + c_0; the d coefficients are given lowest first.
    AlgebraNumber adjoin_root(std::vector<AlgebraNumber> lower_coefficients);
    /// Removes the last level. Elements that need it must not be used any more.
    void drop_level() { levels_.pop_back(); }
    std::size_t levels() const { return levels_.size(); }
    /// The coefficients of 1, w, ... of the last level, as many as its degree.
    std::vector<AlgebraNumber> parts(const AlgebraNumber& value) const;

    AlgebraNumber sum(const AlgebraNumber& a, const AlgebraNumber& b) const;
    AlgebraNumber difference(const AlgebraNumber& a, const AlgebraNumber& b) const;
    AlgebraNumber negative(AlgebraNumber a) const;
    AlgebraNumber product(const AlgebraNumber& a, const AlgebraNumber& b) const;
    /// Errors: `division_by_zero` for zero and for zero divisors.
    AlgebraNumber inverse(const AlgebraNumber& a) const;
    AlgebraNumber quotient(const AlgebraNumber& a, const AlgebraNumber& b) const;
    AlgebraNumber power(const AlgebraNumber& a, std::size_t exponent) const;

    /// Whether an element that needs the level was inverted since `forget_inverses`.
    bool has_inverted(std::size_t level) const { return inverted_ > level; }
    void forget_inverses() { inverted_ = 0; }
    std::size_t highest_inverse() const { return inverted_; }
    void remember_inverse(std::size_t level) { inverted_ = std::max(inverted_, level); }

private:
    enum class LevelKind : std::uint8_t { nilpotent, first_order, root };
    struct Level {
        LevelKind kind;
        std::size_t degree;  ///< over the level below
        std::size_t size;    ///< over Q
        std::vector<AlgebraNumber> relation;
    };

    std::size_t size_below(std::size_t level) const { return level == 0 ? 1 : levels_[level - 1].size; }
    std::size_t level_of(std::size_t size) const;
    void add_level(LevelKind kind, std::size_t degree, std::vector<AlgebraNumber> relation);
    std::vector<AlgebraNumber> parts_at(const AlgebraNumber& value, std::size_t level) const;
    AlgebraNumber joined(const std::vector<AlgebraNumber>& parts, std::size_t level) const;
    AlgebraNumber scaled(AlgebraNumber a, const Rational& factor) const;
    AlgebraNumber product_at(const AlgebraNumber& a, const AlgebraNumber& b, std::size_t level) const;
    AlgebraNumber rational_nilpotent_product(const AlgebraNumber& a, const AlgebraNumber& b,
                                             std::size_t degree) const;
    std::vector<AlgebraNumber> power_parts(const std::vector<AlgebraNumber>& a,
                                           const std::vector<AlgebraNumber>& b, std::size_t level) const;
    AlgebraNumber inverse_by_series(const AlgebraNumber& a, std::size_t level) const;
    AlgebraNumber inverse_by_system(const AlgebraNumber& a, std::size_t level) const;

    Limits limits_;
    std::vector<Level> levels_;
    mutable std::size_t work_ = 0;      ///< products of coordinates
    mutable std::size_t inverted_ = 0;  ///< one more than the highest level of an inverted element
};

/// Pseudorandom numbers that do not depend on the platform.
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next();
    std::uint64_t below(std::uint64_t count) { return next() % count; }
    /// A small number other than 0, 1 and -1, rarely equal to a recent one.
    Rational number();

private:
    std::uint64_t state_;
    std::uint64_t last_ = 0;
};

/// The field of an evaluation at one point: symbols have given values, or random ones.
class PointField {
public:
    using Element = AlgebraNumber;

    PointField(const Limits& limits, std::uint64_t seed) : limits_(limits), algebra_(limits), random_(seed) {}

    Element number(const Rational& value) { return value; }
    Element symbol(const std::string& name);
    Element bound(const std::string&) { return random_.number(); }
    Element sum(const Element& a, const Element& b) { return algebra_.sum(a, b); }
    Element product(const Element& a, const Element& b) { return algebra_.product(a, b); }
    Element negative(const Element& a) { return algebra_.negative(a); }
    Element quotient(const Element& a, const Element& b) { return algebra_.quotient(a, b); }
    Element power(const Element& a, std::size_t exponent) { return algebra_.power(a, exponent); }
    Element derivative(const std::function<Element(const Element&)>& f, const Element& at, std::size_t order);
    std::vector<Element> coefficients(const std::function<Element(const Element&)>& f, std::size_t degree);
    bool is_zero(const Element& a) const { return a.is_zero(); }

    Algebra& algebra() { return algebra_; }
    RandomNumbers& random() { return random_; }
    /// The requested symbols, in the order of their first request.
    const std::vector<std::string>& symbols() const { return order_; }
    bool knows(const std::string& name) const { return values_.contains(name); }
    const Element& value(const std::string& name) const { return values_.at(name); }
    void set(const std::string& name, Element value);
    /// From now on, symbols without a value are an error.
    void require_values() { closed_ = true; }
    /// Calls `watcher` for each requested symbol, to find the symbols on which a line depends.
    void watch(std::function<void(const std::string&)> watcher) { watcher_ = std::move(watcher); }

private:
    std::vector<Element> coefficients_near(const std::function<Element(const Element&)>& f,
                                           std::size_t degree, const Element& near);

    Limits limits_;
    Algebra algebra_;
    RandomNumbers random_;
    std::map<std::string, Element> values_;
    std::vector<std::string> order_;
    std::function<void(const std::string&)> watcher_;
    bool closed_ = false;
};

}  // namespace blossom::proofs::second

#pragma once

#include "plain_polynomial.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace blossom::proofs::second {

/// A power of a numbered factor of denominators.
struct FactorPower {
    std::uint32_t factor;
    std::uint32_t exponent;
    friend bool operator==(const FactorPower&, const FactorPower&) = default;
};

/// Rational functions over Q in named symbols: polynomials over products of numbered factors.
///
/// Every divisor is split into factors: symbols, differences of two symbols, factors met before, and what is
/// left. All of them are kept as conditions, also where they cancel. Denominators are divided by those of
/// their factors that divide the numerator; what is left may still share a factor with it.
class SymbolicField {
public:
    class Element;

    explicit SymbolicField(const Limits& limits) : budget_(limits) {}
    SymbolicField(const SymbolicField&) = delete;
    SymbolicField& operator=(const SymbolicField&) = delete;
    SymbolicField(SymbolicField&&) = delete;
    SymbolicField& operator=(SymbolicField&&) = delete;
    ~SymbolicField() = default;

    Element number(const Rational& value);
    /// The symbol of this name.
    Element symbol(const std::string& name);
    /// From now on the symbol of this name is what is given here.
    void replace(const std::string& name, const Element& by);
    /// A symbol that no name stands for.
    Element bound(const std::string& name);
    Element sum(const Element& a, const Element& b);
    Element product(const Element& a, const Element& b);
    Element negative(const Element& a);
    /// Errors: `division_by_zero` where b is 0.
    Element quotient(const Element& a, const Element& b);
    Element power(const Element& a, std::size_t exponent);
    /// d^order f / dx^order at a value of x.
    Element derivative(const std::function<Element(const Element&)>& f, const Element& at, std::size_t order);
    /// The coefficients of the polynomial f, lowest first, `degree` + 1 of them. Errors: `degree_too_low`;
    /// `syntax` where f is no polynomial.
    std::vector<Element> coefficients(const std::function<Element(const Element&)>& f, std::size_t degree);
    bool is_zero(const Element& a);

    /// The numerator in a form that is 0 exactly where the element is, if no divisor vanishes.
    PlainPolynomial numerator(const Element& a);
    /// Notes that an element other than 0 does not vanish, as if something were divided by it.
    void require_nonzero(const Element& a);
    /// What must not vanish lest some divisor so far does: primitive factors in which no hidden symbol
    /// occurs. A divisor with hidden symbols must not vanish for all their values, which is a condition of
    /// this form where they have only one monomial, and none where a coefficient is a number.
    std::vector<PlainPolynomial> divisors();
    /// The symbols that are bound, or the argument of a function while it is expanded.
    const std::vector<std::size_t>& hidden_symbols() const { return hidden_symbols_; }

    std::optional<std::size_t> number_of(const std::string& name) const;
    std::size_t number_of_or_new(const std::string& name);
    const std::vector<std::string>& names() const { return names_; }
    Budget& budget() { return budget_; }

private:
    using Denominator = std::vector<FactorPower>;  ///< ascending by the factor
    using Part = std::shared_ptr<const PlainPolynomial>;
    struct Sum;

    /// What an element holds; a number is put into `storage`.
    static const Sum& parts_of(const Element& a, Sum& storage);
    const Sum& settled(const Element& a, Sum& storage);
    static PlainPolynomial numerator_of(const Sum& settled);
    /// A number of not too many digits.
    Element checked(Rational number);
    static Element fraction(PlainPolynomial numerator, Denominator denominator);
    void add_part(std::vector<Part>& parts, Part part);
    Element sum_of_fractions(const Sum& a, const Sum& b);

    /// Divides both by the factors of the denominator that divide the numerator.
    void cancel(PlainPolynomial& numerator, Denominator& denominator);
    PlainPolynomial expanded(const Denominator& powers);
    /// The denominator without the factors in which a symbol occurs, and these.
    std::pair<Denominator, Denominator> separated(const Denominator& denominator, std::size_t symbol) const;

    std::size_t new_symbol(std::string name, bool hidden);
    /// a = unit * product of the powers, whose factors are noted.
    Rational split_into_factors(const PlainPolynomial& a, Denominator& powers);
    void divide_out(PlainPolynomial& rest, const PlainPolynomial& factor, Denominator& powers);
    void divide_out_differences(PlainPolynomial& rest, Denominator& powers);
    std::optional<std::uint32_t> known_factor(const PlainPolynomial& factor) const;
    std::uint32_t factor_number(const PlainPolynomial& factor);

    Element derived(const Element& a, std::size_t symbol);
    Element replaced(const Element& a, std::size_t symbol, const Element& by);

    Budget budget_;
    std::map<std::string, std::shared_ptr<const Element>> replaced_;
    std::vector<std::string> names_;
    std::vector<std::size_t> hidden_symbols_;  ///< ascending
    std::unordered_map<std::string, std::size_t> numbers_;
    std::vector<PlainPolynomial> factors_;
    std::unordered_multimap<std::size_t, std::uint32_t> factor_places_;  ///< by hash
};

/// A sum of polynomials over one denominator, the greater ones more than twice as long as the next. They are
/// taken together when more than a sum is asked of it, which is noted in all copies.
struct SymbolicField::Sum {
    std::vector<Part> parts;
    Denominator denominator;
    bool settled = false;  ///< at most one part, and the denominator was divided by what it could be
};

class SymbolicField::Element {
public:
    Element() = default;

private:
    friend class SymbolicField;
    explicit Element(Rational number) : number_(std::move(number)) {}
    explicit Element(std::shared_ptr<Sum> sum) : sum_(std::move(sum)) {}

    Rational number_;  ///< where there is no sum
    std::shared_ptr<Sum> sum_;
};

}  // namespace blossom::proofs::second

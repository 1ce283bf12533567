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
/// Every divisor is split into factors: symbols, differences of two symbols, known factors, and the
/// remainder. All of them are kept as conditions, even if they cancel. Factors of a denominator that divide
/// the numerator are cancelled; the remaining fraction may still have a common factor.
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
    /// From now on, the symbol of this name is the given element.
    void replace(const std::string& name, const Element& by);
    /// A symbol without a name in the text.
    Element bound(const std::string& name);
    Element sum(const Element& a, const Element& b);
    Element product(const Element& a, const Element& b);
    Element negative(const Element& a);
    /// Errors: `division_by_zero` if b is 0.
    Element quotient(const Element& a, const Element& b);
    Element power(const Element& a, std::size_t exponent);
    /// d^order f / dx^order at a value of x.
    Element derivative(const std::function<Element(const Element&)>& f, const Element& at, std::size_t order);
    /// The `degree` + 1 coefficients of the polynomial f, lowest first. Errors: `degree_too_low`; `syntax` if
    /// f is not a polynomial.
    std::vector<Element> coefficients(const std::function<Element(const Element&)>& f, std::size_t degree);
    bool is_zero(const Element& a);

    /// A numerator that is 0 exactly where the element is, if no divisor vanishes.
    PlainPolynomial numerator(const Element& a);
    /// Notes that a nonzero element does not vanish, as a division by it would.
    void require_nonzero(const Element& a);
    /// Primitive factors without hidden symbols that must not vanish, otherwise some divisor so far does. A
    /// divisor with hidden symbols must not vanish for any of their values. This is a condition of the same
    /// form if it has only one monomial in them, and no condition if one of its coefficients is a number.
    std::vector<PlainPolynomial> divisors();
    /// The symbols that are bound, or the argument of a function during its expansion.
    const std::vector<std::size_t>& hidden_symbols() const { return hidden_symbols_; }

    std::optional<std::size_t> number_of(const std::string& name) const;
    std::size_t number_of_or_new(const std::string& name);
    const std::vector<std::string>& names() const { return names_; }
    Budget& budget() { return budget_; }

private:
    using Denominator = std::vector<FactorPower>;  ///< in ascending order of the factors
    using Part = std::shared_ptr<const PlainPolynomial>;
    struct Sum;

    /// The sum in an element; a number is put into `storage`.
    static const Sum& parts_of(const Element& a, Sum& storage);
    const Sum& settled(const Element& a, Sum& storage);
    static PlainPolynomial numerator_of(const Sum& settled);
    /// Checks that a number does not have too many digits.
    Element checked(Rational number);
    static Element fraction(PlainPolynomial numerator, Denominator denominator);
    void add_part(std::vector<Part>& parts, Part part);
    Element sum_of_fractions(const Sum& a, const Sum& b);

    /// Divides both by the factors of the denominator that divide the numerator.
    void cancel(PlainPolynomial& numerator, Denominator& denominator);
    PlainPolynomial expanded(const Denominator& powers);
    /// The denominator without the factors that contain a symbol, and these factors.
    std::pair<Denominator, Denominator> separated(const Denominator& denominator, std::size_t symbol) const;

    std::size_t new_symbol(std::string name, bool hidden);
    /// a = unit * product of the powers; the factors are noted.
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

/// A sum of polynomials over one denominator; each polynomial is more than twice as long as the next. They
/// are added when an operation other than a sum needs the element, and all copies share the result.
struct SymbolicField::Sum {
    std::vector<Part> parts;
    Denominator denominator;
    bool settled = false;  ///< at most one part, and the denominator is reduced as far as possible
};

class SymbolicField::Element {
public:
    Element() = default;

private:
    friend class SymbolicField;
    explicit Element(Rational number) : number_(std::move(number)) {}
    explicit Element(std::shared_ptr<Sum> sum) : sum_(std::move(sum)) {}

    Rational number_;  ///< the value if there is no sum
    std::shared_ptr<Sum> sum_;
};

}  // namespace blossom::proofs::second

#include "symbolic_field.hpp"

#include <algorithm>

namespace blossom::proofs::second {

namespace {

/// Checks exponents in denominators, which no expansion bounds.
std::uint32_t checked_exponent(std::uint64_t exponent) {
    constexpr std::uint64_t greatest = 1 << 20;
    if (exponent > greatest)
        throw Error(ErrorCode::limit_exceeded, "an exponent beyond 2^20 in a denominator");
    return static_cast<std::uint32_t>(exponent);
}

/// The product of two products of powers.
std::vector<FactorPower> product_of_powers(const std::vector<FactorPower>& a,
                                           const std::vector<FactorPower>& b) {
    if (a.empty()) return b;
    std::vector<FactorPower> result;
    auto next = b.begin();
    for (const FactorPower& power : a) {
        while (next != b.end() && next->factor < power.factor) result.push_back(*next++);
        result.push_back(power);
        if (next != b.end() && next->factor == power.factor) {
            result.back().exponent = checked_exponent(std::uint64_t{power.exponent} + (next++)->exponent);
        }
    }
    result.insert(result.end(), next, b.end());
    return result;
}

/// A product of powers divided by its common divisor with another one.
std::vector<FactorPower> powers_without(const std::vector<FactorPower>& a,
                                        const std::vector<FactorPower>& b) {
    std::vector<FactorPower> result;
    for (const FactorPower& power : a) {
        const auto other = std::ranges::lower_bound(b, power.factor, {}, &FactorPower::factor);
        const std::uint32_t shared =
            other != b.end() && other->factor == power.factor ? std::min(other->exponent, power.exponent) : 0;
        if (power.exponent > shared) result.push_back({power.factor, power.exponent - shared});
    }
    return result;
}

}  // namespace

SymbolicField::Element SymbolicField::checked(Rational number) {
    budget_.spend_on_bits(std::max(number.numerator().bit_length(), number.denominator().bit_length()), 1);
    return Element(std::move(number));
}

SymbolicField::Element SymbolicField::number(const Rational& value) { return Element(value); }

SymbolicField::Element SymbolicField::symbol(const std::string& name) {
    const auto replaced = replaced_.find(name);
    if (replaced != replaced_.end()) return *replaced->second;
    return fraction(PlainPolynomial::symbol(number_of_or_new(name)), {});
}

void SymbolicField::replace(const std::string& name, const Element& by) {
    replaced_.insert_or_assign(name, std::make_shared<const Element>(by));
}

SymbolicField::Element SymbolicField::bound(const std::string& name) {
    return fraction(PlainPolynomial::symbol(new_symbol(name, true)), {});
}

std::size_t SymbolicField::new_symbol(std::string name, bool hidden) {
    if (hidden) hidden_symbols_.push_back(names_.size());
    names_.push_back(std::move(name));
    return names_.size() - 1;
}

std::optional<std::size_t> SymbolicField::number_of(const std::string& name) const {
    const auto place = numbers_.find(name);
    return place == numbers_.end() ? std::nullopt : std::optional(place->second);
}

std::size_t SymbolicField::number_of_or_new(const std::string& name) {
    const auto [place, is_new] = numbers_.try_emplace(name, names_.size());
    if (is_new) new_symbol(name, false);
    return place->second;
}

SymbolicField::Element SymbolicField::fraction(PlainPolynomial numerator, Denominator denominator) {
    if (numerator.is_zero()) return {};
    if (denominator.empty() && numerator.is_number()) return Element(numerator.number());
    auto result = std::make_shared<Sum>();
    result->parts.push_back(std::make_shared<const PlainPolynomial>(std::move(numerator)));
    result->denominator = std::move(denominator);
    result->settled = true;
    return Element(std::move(result));
}

const SymbolicField::Sum& SymbolicField::parts_of(const Element& a, Sum& storage) {
    if (a.sum_) return *a.sum_;
    storage = Sum();
    if (!a.number_.is_zero()) storage.parts.push_back(std::make_shared<const PlainPolynomial>(a.number_));
    storage.settled = true;
    return storage;
}

const SymbolicField::Sum& SymbolicField::settled(const Element& a, Sum& storage) {
    if (!a.sum_ || a.sum_->settled) return parts_of(a, storage);
    Sum& sum = *a.sum_;
    PlainPolynomial numerator;
    for (std::size_t k = sum.parts.size(); k-- > 0;) {
        numerator = second::sum(numerator, *sum.parts[k], budget_);
    }
    cancel(numerator, sum.denominator);
    sum.parts.clear();
    if (!numerator.is_zero())
        sum.parts.push_back(std::make_shared<const PlainPolynomial>(std::move(numerator)));
    sum.settled = true;
    return sum;
}

PlainPolynomial SymbolicField::numerator_of(const Sum& settled) {
    return settled.parts.empty() ? PlainPolynomial() : *settled.parts.front();
}

void SymbolicField::add_part(std::vector<Part>& parts, Part part) {
    while (!parts.empty() && parts.back()->size() <= 2 * part->size()) {
        part = std::make_shared<const PlainPolynomial>(second::sum(*parts.back(), *part, budget_));
        parts.pop_back();
    }
    if (!part->is_zero()) parts.push_back(std::move(part));
}

SymbolicField::Element SymbolicField::sum(const Element& a, const Element& b) {
    if (!a.sum_ && !b.sum_) return checked(a.number_ + b.number_);
    if (!a.sum_ && a.number_.is_zero()) return b;
    if (!b.sum_ && b.number_.is_zero()) return a;
    Sum of_a;
    Sum of_b;
    const Sum* left = &parts_of(a, of_a);
    const Sum* right = &parts_of(b, of_b);
    if (left->denominator != right->denominator) {
        left = &settled(a, of_a);
        right = &settled(b, of_b);
        if (left->denominator != right->denominator) return sum_of_fractions(*left, *right);
    }
    auto result = std::make_shared<Sum>(*left);
    for (const Part& part : right->parts) add_part(result->parts, part);
    if (result->parts.empty()) return {};
    result->settled = result->parts.size() == 1 && result->denominator.empty();
    return Element(std::move(result));
}

SymbolicField::Element SymbolicField::sum_of_fractions(const Sum& a, const Sum& b) {
    const Denominator missing_in_a = powers_without(b.denominator, a.denominator);
    const Denominator missing_in_b = powers_without(a.denominator, b.denominator);
    PlainPolynomial numerator =
        second::sum(second::product(numerator_of(a), expanded(missing_in_a), budget_),
                    second::product(numerator_of(b), expanded(missing_in_b), budget_), budget_);
    // A factor with a lower exponent in one denominator divides the other summand, and not this one.
    const Denominator unequal = product_of_powers(missing_in_a, missing_in_b);
    Denominator kept;
    Denominator shared;
    for (const FactorPower& power : product_of_powers(a.denominator, missing_in_a)) {
        const bool is_unequal = std::ranges::binary_search(unequal, power.factor, {}, &FactorPower::factor);
        (is_unequal ? kept : shared).push_back(power);
    }
    cancel(numerator, shared);
    return fraction(std::move(numerator), product_of_powers(kept, shared));
}

SymbolicField::Element SymbolicField::product(const Element& a, const Element& b) {
    if (!a.sum_ && !b.sum_) return checked(a.number_ * b.number_);
    if (!a.sum_ || !b.sum_) {
        const Rational& factor = a.sum_ ? b.number_ : a.number_;
        if (factor.is_zero()) return {};
        auto result = std::make_shared<Sum>(a.sum_ ? *a.sum_ : *b.sum_);
        if (factor == Rational(1)) return Element(std::move(result));
        for (Part& part : result->parts) {
            part = std::make_shared<const PlainPolynomial>(scaled(*part, factor, budget_));
        }
        return Element(std::move(result));
    }
    Sum storage;
    const Sum& left = settled(a, storage);
    const Sum& right = settled(b, storage);
    PlainPolynomial of_a = numerator_of(left);
    PlainPolynomial of_b = numerator_of(right);
    Denominator under_a = left.denominator;
    Denominator under_b = right.denominator;
    cancel(of_a, under_b);
    cancel(of_b, under_a);
    return fraction(second::product(of_a, of_b, budget_), product_of_powers(under_a, under_b));
}

SymbolicField::Element SymbolicField::negative(const Element& a) { return product(Element(Rational(-1)), a); }

SymbolicField::Element SymbolicField::quotient(const Element& a, const Element& b) {
    Sum of_b;
    const Sum& divisor = settled(b, of_b);
    if (divisor.parts.empty()) throw Error(ErrorCode::division_by_zero, "a divisor is 0 for all values");
    if (!b.sum_) return product(a, Element(Rational(1) / b.number_));
    Denominator powers;
    const Rational unit = split_into_factors(numerator_of(divisor), powers);
    Sum of_a;
    const Sum& dividend = settled(a, of_a);
    PlainPolynomial numerator = scaled(numerator_of(dividend), Rational(1) / unit, budget_);
    cancel(numerator, powers);
    const Denominator above = powers_without(divisor.denominator, dividend.denominator);
    const Denominator below = powers_without(dividend.denominator, divisor.denominator);
    return fraction(second::product(numerator, expanded(above), budget_), product_of_powers(below, powers));
}

SymbolicField::Element SymbolicField::power(const Element& a, std::size_t exponent) {
    if (exponent == 0) return Element(Rational(1));
    if (!a.sum_) return Element(second::power(PlainPolynomial(a.number_), exponent, budget_).number());
    if (exponent >= 1 << 15) throw Error(ErrorCode::limit_exceeded, "an exponent of 32768 or more");
    Sum storage;
    const Sum& base = settled(a, storage);
    Denominator denominator = base.denominator;
    for (FactorPower& power : denominator)
        power.exponent = checked_exponent(std::uint64_t{power.exponent} * exponent);
    return fraction(second::power(numerator_of(base), exponent, budget_), std::move(denominator));
}

bool SymbolicField::is_zero(const Element& a) {
    if (!a.sum_) return a.number_.is_zero();
    Sum storage;
    return settled(a, storage).parts.empty();
}

PlainPolynomial SymbolicField::numerator(const Element& a) {
    Sum storage;
    return numerator_of(settled(a, storage));
}

void SymbolicField::require_nonzero(const Element& a) { quotient(Element(Rational(1)), a); }

void SymbolicField::cancel(PlainPolynomial& numerator, Denominator& denominator) {
    if (numerator.is_zero()) denominator.clear();
    std::size_t kept = 0;
    for (FactorPower& power : denominator) {
        while (power.exponent > 0) {
            std::optional<PlainPolynomial> exact = exact_quotient(numerator, factors_[power.factor], budget_);
            if (!exact) break;
            numerator = std::move(*exact);
            --power.exponent;
        }
        if (power.exponent > 0) denominator[kept++] = power;
    }
    denominator.resize(kept);
}

PlainPolynomial SymbolicField::expanded(const Denominator& powers) {
    PlainPolynomial result(1);
    for (const FactorPower& power : powers) {
        result =
            second::product(result, second::power(factors_[power.factor], power.exponent, budget_), budget_);
    }
    return result;
}

}  // namespace blossom::proofs::second

#include "sturm.hpp"

namespace blossom::testing {

namespace {

/// A positive multiple whose coefficients are coprime integers.
Polynomial primitive(const Polynomial& polynomial) {
    Integer content;
    for (const Integer& coefficient : polynomial.coefficients().numerators())
        content = gcd(content, coefficient);
    return Polynomial(Rational(polynomial.coefficients().denominator(), content)) * polynomial;
}

}  // namespace

// The common divisor of P and P' divides the whole sequence, so that the sequence counts distinct roots;
// dividing by it also makes the signs at multiple roots correct.
SturmSequence::SturmSequence(const Polynomial& polynomial) {
    const Polynomial simple = divide_exactly(polynomial, gcd(polynomial, derivative(polynomial)));
    sequence_.push_back(primitive(simple));
    Polynomial next = derivative(simple);
    while (!next.is_zero()) {
        sequence_.push_back(primitive(next));
        next = -divide(sequence_[sequence_.size() - 2], sequence_.back()).second;
    }
}

std::size_t SturmSequence::sign_changes(const Rational& t) const {
    std::size_t changes = 0;
    int last = 0;
    for (const Polynomial& polynomial : sequence_) {
        const int sign = polynomial(t).sign();
        if (sign == 0) continue;
        if (last != 0 && sign != last) ++changes;
        last = sign;
    }
    return changes;
}

}  // namespace blossom::testing

#include "knot_weights.hpp"

#include <algorithm>

namespace blossom {

KnotWeights::KnotWeights(const Rational& begin, const Rational& end, const Rational& x)
    : left_((end.numerator() * x.denominator() - x.numerator() * end.denominator()) * begin.denominator()),
      right_((x.numerator() * begin.denominator() - begin.numerator() * x.denominator()) * end.denominator()),
      length_(left_ + right_) {}

void KnotWeights::combine(std::span<const Rational> a, std::span<const Rational> b, std::span<Rational> to,
                          const Limits& limits) const {
    for (std::size_t j = 0; j < to.size(); ++j) {
        to[j] = combination(left_, a[j], right_, b[j], length_);
        if (to[j].numerator().is_word() && to[j].denominator().is_word()) continue;
        require_result_bits(std::max(to[j].numerator().bit_length(), to[j].denominator().bit_length()),
                            limits);
    }
}

}  // namespace blossom

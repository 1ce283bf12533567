#include "number_generators.hpp"

#include <iterator>

namespace blossom::testing {

namespace {

IntegerKind integer_kind(Random& random) {
    const std::uint64_t share = random.below(16);
    if (share < 3) return IntegerKind::unit;
    if (share < 7) return IntegerKind::tiny;
    if (share < 10) return IntegerKind::word;
    if (share < 14) return IntegerKind::boundary;
    return IntegerKind::huge;
}

Integer boundary(Random& random) {
    Integer value = Integer(1) << boundary_exponents[random.below(std::size(boundary_exponents))];
    if (random.one_in(2)) value.negate();
    return value + Integer(random.between(-2, 2));
}

Integer nonzero_integer(Random& random) {
    Integer value = integer(random);
    while (value.is_zero()) value = integer(random);
    return value;
}

}  // namespace

Integer integer_of_bits(Random& random, std::size_t bits) {
    Integer value;
    for (std::size_t done = 0; done < bits; done += 64) value = (value << 64) + Integer(random.word());
    if (bits == 0) return value;
    value = (value % (Integer(1) << (bits - 1))) + (Integer(1) << (bits - 1));
    return random.one_in(2) ? -value : value;
}

Integer integer(Random& random, IntegerKind kind) {
    switch (kind) {
        case IntegerKind::unit:
            return random.between(-1, 1);
        case IntegerKind::tiny:
            return random.between(-100, 100);
        case IntegerKind::word:
            return static_cast<std::int64_t>(random.word());
        case IntegerKind::boundary:
            return boundary(random);
        case IntegerKind::huge:
            return integer_of_bits(random, 65 + random.below(636));
    }
    return 0;
}

Integer integer(Random& random) { return integer(random, integer_kind(random)); }

Rational small_rational(Random& random) {
    const Integer numerator = random.between(-12, 12);
    return {numerator, random.between(1, 9)};
}

Rational rational(Random& random) {
    const std::uint64_t share = random.below(4);
    if (share < 2) return small_rational(random);
    if (share < 3) return integer(random);
    Integer numerator = integer(random);
    return {std::move(numerator), nonzero_integer(random)};
}

}  // namespace blossom::testing

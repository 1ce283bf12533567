#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/made_once.hpp>
#include <blossom/rational/net_sums.hpp>
#include <blossom/rational/resource_budget.hpp>

#include <mutex>
#include <optional>

#include "net_rings.hpp"
#include "net_weights.hpp"
#include "quotients/power_denominator.hpp"
#include "residues/residue_numbers.hpp"
#include "sums/fixed_width_rows.hpp"
#include "sums/word_sums.hpp"

namespace blossom {

namespace {

/// The numbers of a net modulo the first groups of primes.
using NetResidues = std::shared_ptr<const std::vector<residues::ResidueVector>>;

/// Smaller nets are summed in integers if words do not suffice (by measurement).
constexpr std::size_t least_residue_numbers = 24;
/// The most memory that residues may take, in bytes.
constexpr std::size_t most_residue_bytes = std::size_t{64} << 20;

}  // namespace

struct NetSums::Prepared {
    Prepared(RationalVector given, std::size_t row_count, std::vector<SimplexFactor> factors, Integer bound)
        : numbers(std::move(given)),
          rows(row_count),
          size(numbers.size() / row_count),
          shape(std::move(factors)),
          greatest(std::move(bound)),
          bits(greatest_bit_length(numbers.numerators())) {
        for (const SimplexFactor& factor : shape) {
            counts.push_back(net_weights::count_of(factor.dimension, factor.degree));
            weights += counts.back();
            longest = std::max(longest, counts.back());
        }
    }

    const std::uint64_t* of(WordRing<std::uint64_t> ring) const { return read_once(ring, words); }
    const UInt128* of(WordRing<UInt128> ring) const { return read_once(ring, wide); }
    const Integer* of(IntegerRing) const { return numbers.numerators().data(); }

    /// The residues of all rows, one group after the other, kept for the next call.
    NetResidues residues_for(std::size_t groups) const {
        {
            const std::lock_guard lock(mutex);
            if (kept && kept->size() >= groups * numbers.size()) return kept;
        }
        auto made = std::make_shared<std::vector<residues::ResidueVector>>(groups * numbers.size());
        const residues::Numbers all(numbers.numerators(), numbers.denominator(), groups);
        for (std::size_t g = 0; g < groups; ++g)
            all.residues(residues::moduli(g), made->data() + g * numbers.size());
        const std::lock_guard lock(mutex);
        kept = made;
        return made;
    }

    RationalVector numbers;
    std::size_t rows;
    std::size_t size;  ///< of a row
    std::vector<SimplexFactor> shape;
    std::vector<std::size_t> counts;  ///< of the weights per factor
    std::size_t weights = 0;          ///< the number of all weights
    std::size_t longest = 0;          ///< the largest count
    Integer greatest;
    std::size_t bits;  ///< of the numbers

private:
    /// The numbers in a ring.
    template <class Number>
    using Read = MadeOnce<std::vector<Number>>;

    template <class Ring>
    const typename Ring::Number* read_once(Ring ring, const Read<typename Ring::Number>& read) const {
        const auto& all = read.value([&] {
            std::vector<typename Ring::Number> made(numbers.size());
            ring.read(std::span(numbers.numerators()), made.data());
            return made;
        });
        return all.data();
    }

    Read<std::uint64_t> words;
    Read<UInt128> wide;
    mutable std::mutex mutex;
    mutable NetResidues kept;
};

namespace {

using Prepared = NetSums::Prepared;

enum class Weights { monomials, products };

/// The arguments of one call, tuple by tuple.
template <class R>
struct Tuples {
    const Prepared& net;
    const NetArguments<R>& given;
    Weights weights;

    /// Calls visit(entries, scale, times) for each tuple.
    template <class Visit>
    void each(const Visit& visit) const {
        const R* entries = given.entries.data();
        const R* scale = given.scales.data();
        for (const auto& [dimension, degree] : net.shape) {
            const bool powers = weights == Weights::monomials;
            for (std::size_t i = 0; i < (powers ? 1 : degree); ++i, entries += dimension + 1)
                visit(std::span(entries, dimension + 1), *scale++, powers ? degree : 1);
        }
    }
};

/// A bound on the bits of the sums.
std::size_t sum_bits(const Tuples<std::int64_t>& tuples) {
    fixed_width::BitBound bound(tuples.net.greatest.is_word() ? 0 : tuples.net.greatest.bit_length());
    bound.multiply(magnitude(tuples.net.greatest.word()));
    tuples.each([&](std::span<const std::int64_t> entries, std::int64_t, std::size_t times) {
        UInt128 norm = 0;
        for (const std::int64_t entry : entries) norm += magnitude(entry);
        for (std::size_t i = 0; i < times; ++i) bound.multiply(norm);
    });
    return bound.bits();
}

std::size_t sum_bits(const Tuples<Integer>& tuples) {
    std::size_t bits = tuples.net.greatest.bit_length();
    tuples.each([&](std::span<const Integer> entries, const Integer&, std::size_t times) {
        Integer norm;
        for (const Integer& entry : entries) norm += abs(entry);
        bits += times * norm.bit_length();
    });
    return bits;
}

/// The most frequent tuple of a list.
template <class R>
struct MostFrequent {
    MostFrequent(const R* list, std::size_t size, std::size_t count) : tuple(list, size) {
        for (std::size_t i = 0; i < count; ++i) {
            const std::span<const R> here(list + i * size, size);
            std::size_t found = 1;
            for (std::size_t k = i + 1; k < count; ++k)
                found += static_cast<std::size_t>(std::equal(here.begin(), here.end(), list + k * size));
            if (found > times) {
                tuple = here;
                times = found;
            }
        }
    }

    std::span<const R> tuple;
    std::size_t times = 0;
};

/// The coefficients of the product of the linear forms `given`, whose images in the ring are `forms`: the
/// power of the most frequent form by the multinomial theorem, multiplied by the others one after the other.
template <class Ring, class R>
void set_products(const Ring& ring, const SimplexFactor& factor, const R* given,
                  const typename Ring::Number* forms, typename Ring::Number* weights,
                  typename Ring::Number* room) {
    const std::size_t size = factor.dimension + 1;
    const MostFrequent<R> most(given, size, factor.degree);
    weights[0] = ring.one();
    std::size_t degree = 0;
    if (most.times > 1) {
        const SimplexFactor power{factor.dimension, most.times};
        const std::vector<Integer> multinomials = multinomial_row(power);
        ring.read(std::span(multinomials), room);
        net_weights::set_monomials(ring, power, forms + (most.tuple.data() - given), weights);
        ring.multiply_each(weights, weights, room, multinomials.size());
        degree = most.times;
    }
    for (std::size_t i = 0; i < factor.degree; ++i) {
        if (most.times > 1 && std::equal(most.tuple.begin(), most.tuple.end(), given + i * size)) continue;
        net_weights::multiply_by_form(ring, factor.dimension, degree++, forms + i * size, weights, room);
    }
}

/// Calls visit(sum) for the rows of the net in order.
template <class Ring, class R, class Visit>
[[gnu::always_inline]] inline void each_sum(const Ring& ring, const Tuples<R>& tuples,
                                            const typename Ring::Number* numbers, const Visit& visit) {
    const Prepared& net = tuples.net;
    if (net.shape.empty()) {
        for (std::size_t j = 0; j < net.rows; ++j) visit(numbers[j]);
        return;
    }
    const std::size_t entries = tuples.given.entries.size();
    typename Ring::Room memory(entries + net.weights +
                               std::max(tuples.weights == Weights::products ? net.longest : 0,
                                        net.shape.size() > 1 ? net.size / net.counts.back() : 0));
    auto* const x = memory.data();
    auto* const weights = x + entries;
    auto* const room = weights + net.weights;
    ring.read(tuples.given.entries, x);
    auto* to = weights;
    std::size_t place = 0;
    for (std::size_t f = 0; f < net.shape.size(); ++f) {
        const SimplexFactor& factor = net.shape[f];
        if (tuples.weights == Weights::monomials) {
            f == 0 ? net_weights::set_blocks(ring, factor, x, to)
                   : net_weights::set_monomials(ring, factor, x + place, to);
            place += factor.dimension + 1;
        } else {
            set_products(ring, factor, tuples.given.entries.data() + place, x + place, to, room);
            place += factor.degree * (factor.dimension + 1);
        }
        to += net.counts[f];
    }
    for (std::size_t j = 0; j < net.rows; ++j) {
        const auto* const first =
            net_weights::contracted_to_first(ring, net.counts, numbers + j * net.size, net.size, to, room);
        visit(tuples.weights == Weights::monomials
                  ? net_weights::sum_of_blocks(ring, net.shape[0], x[0], first, weights)
                  : ring.dot(first, weights, net.counts[0]));
    }
}

template <class R>
PowerDenominator power_denominator(const Tuples<R>& tuples) {
    PowerDenominator denominator;
    denominator.multiply(tuples.net.numbers.denominator(), 1);
    tuples.each(
        [&](std::span<const R>, const R& scale, std::size_t times) { denominator.multiply(scale, times); });
    return denominator;
}

template <class R>
void evaluate_by_residues(const Tuples<R>& tuples, std::size_t groups, std::span<Rational> sums) {
    constexpr std::uint64_t words_per_number = 64;
    const Prepared& net = tuples.net;
    const NetResidues numbers = net.residues_for(groups);
    Room<residues::ResidueVector, 16> found(net.rows * groups);
    for (std::size_t g = 0; g < groups; ++g) {
        spend_work(words_per_number * (net.numbers.size() + net.weights));
        residues::ResidueVector* to = found.data() + g;
        each_sum(ResidueRing(residues::moduli(g)), tuples, numbers->data() + g * net.numbers.size(),
                 [&](const residues::ResidueVector& sum) {
                     *to = sum;
                     to += groups;
                 });
    }
    const PowerDenominator denominator = power_denominator(tuples);
    for (std::size_t j = 0; j < net.rows; ++j)
        sums[j] = denominator.quotient(residues::integer_with({found.data() + j * groups, groups}));
}

template <class R>
void evaluate_beyond_words(const Tuples<R>& tuples, std::size_t bits, std::span<Rational> sums) {
    if (tuples.net.size >= least_residue_numbers && bits <= residues::most_bits) {
        const std::size_t groups = residues::groups_for(bits);
        if (tuples.net.numbers.size() * groups <= most_residue_bytes / sizeof(residues::ResidueVector))
            return evaluate_by_residues(tuples, groups, sums);
    }
    const PowerDenominator denominator = power_denominator(tuples);
    auto value = sums.begin();
    each_sum(IntegerRing(), tuples, tuples.net.of(IntegerRing()),
             [&](const Integer& sum) { *value++ = denominator.quotient(sum); });
}

/// The denominator of all sums as one word below 2^63; 0 if it is larger.
word_sums::WordDenominator word_denominator(const Tuples<std::int64_t>& tuples) {
    const Integer& own = tuples.net.numbers.denominator();
    if (!own.is_word()) return {};
    std::int64_t product = own.word();
    small_primes::SetOfFactors primes(small_primes::primes_of(static_cast<std::uint64_t>(product)));
    bool overflow = false;
    tuples.each([&](std::span<const std::int64_t>, std::int64_t scale, std::size_t times) {
        for (std::size_t i = 0; i < times; ++i) overflow |= __builtin_mul_overflow(product, scale, &product);
        primes.add(static_cast<std::uint64_t>(scale));
    });
    return overflow ? word_sums::WordDenominator{} : word_sums::WordDenominator{product, primes.set()};
}

/// The same in several words; nullopt if there are too many.
std::optional<DenominatorWords> denominator_words(const Tuples<std::int64_t>& tuples) {
    const Integer& own = tuples.net.numbers.denominator();
    std::size_t bits = own.bit_length();
    tuples.each([&](std::span<const std::int64_t>, std::int64_t scale, std::size_t times) {
        bits += times * static_cast<std::size_t>(std::bit_width(magnitude(scale)));
    });
    // Adjacent words in the list have a product beyond one word.
    if (!own.is_word() || bits / 32 >= DenominatorWords::most_words) return std::nullopt;
    std::optional<DenominatorWords> words(std::in_place);
    const auto multiply = [&](std::int64_t factor, std::size_t times) {
        const auto word = static_cast<std::uint64_t>(factor);
        for (std::size_t i = 0; i < times; ++i) words->multiply(word, small_primes::primes_of(word));
    };
    multiply(own.word(), 1);
    tuples.each([&](std::span<const std::int64_t>, std::int64_t scale, std::size_t times) {
        multiply(scale, times);
    });
    return words;
}

bool evaluate_wide(const Tuples<std::int64_t>& tuples, std::span<Rational> sums) {
    const auto denominator = denominator_words(tuples);
    if (!denominator) return false;
    auto value = sums.begin();
    const WordRing<UInt128> ring;
    each_sum(ring, tuples, tuples.net.of(ring),
             [&](UInt128 sum) { word_sums::assign_quotient(*value++, sum, *denominator); });
    return true;
}

void evaluate(const Tuples<std::int64_t>& tuples, std::span<Rational> sums) {
    const std::size_t bits = std::max(sum_bits(tuples), tuples.net.bits);
    if (bits < 64) {
        if (const auto denominator = word_denominator(tuples); denominator.value != 0) {
            auto value = sums.begin();
            const WordRing<std::uint64_t> ring;
            each_sum(ring, tuples, tuples.net.of(ring), [&](std::uint64_t sum) {
                assign_quotient(*value++, static_cast<std::int64_t>(sum),
                                static_cast<std::uint64_t>(denominator.value), denominator.primes);
            });
            return;
        }
    }
    if (bits >= 128 || !evaluate_wide(tuples, sums)) evaluate_beyond_words(tuples, bits, sums);
}

void evaluate(const Tuples<Integer>& tuples, std::span<Rational> sums) {
    evaluate_beyond_words(tuples, sum_bits(tuples), sums);
}

}  // namespace

NetSums::NetSums(RationalVector numbers, std::size_t rows, std::vector<SimplexFactor> shape, Integer greatest)
    : prepared_(std::make_shared<const Prepared>(std::move(numbers), rows, std::move(shape),
                                                 std::move(greatest))) {}

std::size_t NetSums::rows() const { return prepared_->rows; }
std::span<const SimplexFactor> NetSums::shape() const { return prepared_->shape; }

std::size_t NetSums::sum_bits(std::size_t bits_of_tuple) const {
    std::size_t degree = 0;
    for (const SimplexFactor& factor : prepared_->shape) degree += factor.degree;
    return std::max(prepared_->greatest.bit_length(), prepared_->numbers.denominator().bit_length()) +
           degree * bits_of_tuple;
}

void NetSums::values(const NetArguments<std::int64_t>& tuples, std::span<Rational> sums) const {
    evaluate(Tuples<std::int64_t>{*prepared_, tuples, Weights::monomials}, sums);
}
void NetSums::values(const NetArguments<Integer>& tuples, std::span<Rational> sums) const {
    evaluate(Tuples<Integer>{*prepared_, tuples, Weights::monomials}, sums);
}
void NetSums::multilinear_values(const NetArguments<std::int64_t>& tuples, std::span<Rational> sums) const {
    evaluate(Tuples<std::int64_t>{*prepared_, tuples, Weights::products}, sums);
}
void NetSums::multilinear_values(const NetArguments<Integer>& tuples, std::span<Rational> sums) const {
    evaluate(Tuples<Integer>{*prepared_, tuples, Weights::products}, sums);
}

// The coefficients with i_0 = n - b are C(n, b) times those of degree b in the other variables.
std::vector<Integer> multinomial_row(const SimplexFactor& factor) {
    const auto [dimension, degree] = factor;
    if (dimension == 0) return {1};
    std::vector<Integer> binomials = binomial_row(degree);
    if (dimension == 1) return binomials;
    std::vector<Integer> row;
    row.reserve(net_weights::count_of(dimension, degree));
    for (std::size_t b = 0; b <= degree; ++b) {
        for (const Integer& multinomial : multinomial_row({dimension - 1, b}))
            row.push_back(binomials[b] * multinomial);
    }
    return row;
}

}  // namespace blossom

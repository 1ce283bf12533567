#include "residue_system.hpp"

#include <cstdlib>
#include <deque>
#include <mutex>
#include <string_view>

#include "backend.hpp"
#include "wide.hpp"

namespace blossom::residues {

namespace {

constexpr std::size_t digit_bits = 50;

std::uint64_t product(std::uint64_t a, std::uint64_t b, std::uint64_t prime) {
    return static_cast<std::uint64_t>(Wide{a} * b % prime);
}

std::uint64_t power(std::uint64_t base, std::uint64_t exponent, std::uint64_t prime) {
    std::uint64_t result = 1;
    for (; exponent != 0; exponent >>= 1) {
        if (exponent & 1) result = product(result, base, prime);
        base = product(base, base, prime);
    }
    return result;
}

/// By the test of Miller and Rabin, which these bases decide for 64 bits (Sorenson and Webster, 2015).
bool is_prime(std::uint64_t odd) {
    const int twos = std::countr_zero(odd - 1);
    for (const std::uint64_t base : {2U, 3U, 5U, 7U, 11U, 13U, 17U, 19U, 23U, 29U, 31U, 37U}) {
        std::uint64_t x = power(base, (odd - 1) >> twos, odd);
        bool passes = x == 1 || x == odd - 1;
        for (int i = 1; i < twos && !passes; ++i) {
            x = product(x, x, odd);
            passes = x == odd - 1;
        }
        if (!passes) return false;
    }
    return true;
}

/// -1/p modulo 2^52, by Newton's iteration.
std::uint64_t negative_inverse(std::uint64_t prime) {
    std::uint64_t inverse = prime;
    for (int i = 0; i < 5; ++i) inverse *= 2 - prime * inverse;
    return (0 - inverse) & ((std::uint64_t{1} << 52) - 1);
}

Moduli next_group(std::uint64_t& candidate) {
    Moduli group{};
    for (std::size_t i = 0; i < lanes; ++i) {
        do candidate -= 2;
        while (!is_prime(candidate));
        const std::uint64_t radix = (std::uint64_t{1} << 52) % candidate;
        group.prime.lane[i] = candidate;
        group.delta.lane[i] = (std::uint64_t{1} << 50) - candidate;
        group.negative_inverse.lane[i] = negative_inverse(candidate);
        group.square.lane[i] = product(radix, radix, candidate);
    }
    return group;
}

std::vector<Octet> powers(const Moduli& moduli, std::size_t count, Octet first) {
    std::vector<Octet> result;
    result.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
        result.push_back(first);
        for (std::size_t i = 0; i < lanes; ++i)
            first.lane[i] = product(first.lane[i], moduli.delta.lane[i], moduli.prime.lane[i]);
    }
    return result;
}

/// What the Chinese remainder theorem needs for a number of groups.
struct Tables {
    explicit Tables(std::size_t groups);

    Integer combined(std::span<const Octet> residues) const;

    /// sum over the primes p of one group of residue_p * (product of the group / p).
    Integer group_sum(const Octet& residues, std::size_t group) const;

    static constexpr std::size_t cofactor_words = 6;  ///< of a product of seven primes

    std::vector<Octet> inverses;  ///< of (product of all) / p, times 2^52
    std::vector<std::uint64_t> cofactors;
    std::vector<std::vector<Integer>> levels;  ///< products of 1, 2, 4, ... groups
    Integer half;
};

Tables::Tables(std::size_t groups) {
    std::vector<std::uint64_t> primes;
    for (std::size_t g = 0; g < groups; ++g)
        primes.insert(primes.end(), std::begin(moduli(g).prime.lane), std::end(moduli(g).prime.lane));
    levels.emplace_back();
    for (std::size_t g = 0; g < groups; ++g) {
        Octet inverse{};
        Integer group_product = 1;
        for (std::size_t i = 0; i < lanes; ++i) {
            const std::uint64_t prime = primes[g * lanes + i];
            std::uint64_t others = 1;
            Integer cofactor = 1;
            for (std::size_t j = 0; j < primes.size(); ++j) {
                if (j == g * lanes + i) continue;
                others = product(others, primes[j], prime);
                if (j / lanes == g) cofactor *= primes[j];
            }
            inverse.lane[i] =
                product(power(others, prime - 2, prime), (std::uint64_t{1} << 52) % prime, prime);
            cofactors.resize(cofactors.size() + cofactor_words);
            IntegerAccess::to_twos_complement(cofactor, std::span(cofactors).last(cofactor_words));
            group_product *= prime;
        }
        inverses.push_back(inverse);
        levels[0].push_back(group_product);
    }
    while (levels.back().size() > 1) {
        const std::vector<Integer>& below = levels.back();
        std::vector<Integer> level;
        for (std::size_t i = 0; i + 1 < below.size(); i += 2) level.push_back(below[i] * below[i + 1]);
        if (below.size() % 2 == 1) level.push_back(below.back());
        levels.push_back(std::move(level));
    }
    half = levels.back()[0] >> 1;
}

Integer Tables::group_sum(const Octet& residues, std::size_t group) const {
    std::uint64_t sum[cofactor_words + 1] = {};
    for (std::size_t i = 0; i < lanes; ++i) {
        const std::uint64_t* cofactor = cofactors.data() + (group * lanes + i) * cofactor_words;
        Wide carry = 0;
        for (std::size_t w = 0; w < cofactor_words; ++w) {
            carry += Wide{cofactor[w]} * residues.lane[i] + sum[w];
            sum[w] = static_cast<std::uint64_t>(carry);
            carry >>= 64;
        }
        sum[cofactor_words] += static_cast<std::uint64_t>(carry);
    }
    return IntegerAccess::from_magnitude(sum, false);
}

Integer Tables::combined(std::span<const Octet> residues) const {
    std::vector<Integer> sums;
    sums.reserve(residues.size());
    for (std::size_t g = 0; g < residues.size(); ++g)
        sums.push_back(group_sum(operations().dot(moduli(g), &residues[g], &inverses[g], 1), g));
    for (const std::vector<Integer>& products : std::span(levels).first(levels.size() - 1)) {
        std::size_t above = 0;
        for (std::size_t i = 0; i < sums.size(); i += 2, ++above) {
            if (i + 1 == sums.size()) {
                sums[above] = std::move(sums[i]);
            } else {
                Integer sum = sums[i] * products[i + 1];
                sum.add_product(sums[i + 1], products[i]);
                sums[above] = std::move(sum);
            }
        }
        sums.resize(above);
    }
    const Integer& all = levels.back()[0];
    Integer value = std::move(sums[0]) % all;
    if (value > half) value -= all;
    return value;
}

std::shared_ptr<const Tables> tables(std::size_t groups) {
    constexpr std::size_t most_kept = 32;
    static std::mutex mutex;
    static std::deque<std::pair<std::size_t, std::shared_ptr<const Tables>>> kept;
    {
        const std::lock_guard lock(mutex);
        for (const auto& [size, found] : kept) {
            if (size == groups) return found;
        }
    }
    auto made = std::make_shared<const Tables>(groups);
    const std::lock_guard lock(mutex);
    kept.emplace_back(groups, made);
    if (kept.size() > most_kept) kept.pop_front();
    return made;
}

const Operations& chosen_operations() {
#if defined(BLOSSOM_AVX512_IFMA)
    // NOLINTNEXTLINE(concurrency-mt-unsafe): read once, and nothing here writes the environment
    const char* level = std::getenv("BLOSSOM_VECTOR_LEVEL");
    const bool excluded = level && std::string_view(level) != "ifma";
    if (!excluded && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512ifma"))
        return ifma_operations;
#endif
    return portable_operations;
}

}  // namespace

const Operations& operations() {
    static const Operations& chosen = chosen_operations();
    return chosen;
}

const Moduli& moduli(std::size_t group) {
    static std::mutex mutex;
    static std::deque<Moduli> groups;  // Keeps its elements in place.
    static std::uint64_t candidate = (std::uint64_t{1} << 50) + 1;
    const std::lock_guard lock(mutex);
    while (groups.size() <= group) groups.push_back(next_group(candidate));
    return groups[group];
}

void Digits::reserve(std::size_t values) {
    digits_.reserve(2 * values);
    words_.reserve(values);
    begins_.reserve(values + 1);
    negative_.reserve(values);
}

void Digits::finish(bool negative) {
    most_digits_ = std::max(most_digits_, digits_.size() - begins_.back());
    begins_.push_back(digits_.size());
    negative_.push_back(negative);
}

void Digits::push_back(std::int64_t value) {
    words_.push_back(value);
    for (std::uint64_t rest = magnitude(value); rest != 0; rest >>= digit_bits)
        digits_.push_back(rest & low_50);
    finish(value < 0);
}

void Digits::push_back(const Integer& value) {
    if (const auto word = value.to_int64()) return push_back(*word);
    const std::size_t bits = value.bit_length();
    std::vector<std::uint64_t> words(bits / 64 + 2);
    IntegerAccess::to_twos_complement(abs(value), words);
    for (std::size_t bit = 0; bit < bits; bit += digit_bits) {
        const std::size_t word = bit / 64;
        const Wide pair = Wide{words[word + 1]} << 64 | words[word];
        digits_.push_back(static_cast<std::uint64_t>(pair >> (bit % 64)) & low_50);
    }
    finish(value.sign() < 0);
}

Octet Digits::residues(std::size_t i, const Moduli& moduli, const Octet* powers) const {
    Octet result{};
    for (std::size_t begin = begins_[i]; begin < begins_[i + 1]; begin += most_terms) {
        const Octet part =
            operations().digit_dot(moduli, digits_.data() + begin, powers + (begin - begins_[i]),
                                   std::min(most_terms, begins_[i + 1] - begin));
        for (std::size_t l = 0; l < lanes; ++l) {
            const std::uint64_t sum = result.lane[l] + part.lane[l];
            result.lane[l] = sum >= moduli.prime.lane[l] ? sum - moduli.prime.lane[l] : sum;
        }
    }
    if (!negative_[i]) return result;
    for (std::size_t l = 0; l < lanes; ++l)
        result.lane[l] = result.lane[l] == 0 ? 0 : moduli.prime.lane[l] - result.lane[l];
    return result;
}

std::vector<Octet> plain_powers(const Moduli& moduli, std::size_t count) {
    Octet first{};
    for (std::size_t i = 0; i < lanes; ++i) first.lane[i] = (std::uint64_t{1} << 52) % moduli.prime.lane[i];
    return powers(moduli, count, first);
}

std::vector<Octet> montgomery_powers(const Moduli& moduli, std::size_t count) {
    return powers(moduli, count, moduli.square);
}

Integer integer_with(std::span<const Octet> residues) { return tables(residues.size())->combined(residues); }

}  // namespace blossom::residues

#include "polarization.hpp"

#include <blossom/rational/subset_sums.hpp>

#include "maps/integer_tuple.hpp"
#include "run_construction.hpp"

namespace blossom {

namespace {

/// Sums of fewer terms are evaluated directly, because the preparation of the primes takes longer.
constexpr std::size_t fewest_terms_by_primes = 32;

bool is_point_or_vector(const Argument& argument) {
    return argument.mass.is_zero() || argument.mass == Rational(1);
}

/// The arguments scaled to masses 0 and 1.
std::vector<Argument> with_unit_masses(std::span<const Argument> arguments) {
    std::vector<Argument> result(arguments.begin(), arguments.end());
    for (Argument& argument : result)
        if (!is_point_or_vector(argument)) argument = Argument(argument.u / argument.mass, 1);
    return result;
}

/// The factor by which the value at the arguments `with_unit_masses` is multiplied.
Rational product_of_masses(std::span<const Argument> arguments) {
    Rational product = 1;
    for (const Argument& argument : arguments)
        if (!argument.mass.is_zero()) product *= argument.mass;
    return product;
}

std::vector<SubsetGroup> groups_of(std::span<const HomogeneousPair<Integer>> pairs) {
    std::vector<SubsetGroup> groups;
    for (const auto& [pair, multiplicity] : constructions::grouped(pairs))
        groups.push_back({pair.u, pair.mass, multiplicity});
    return groups;
}

/// The value by residues, if they suffice.
std::optional<Coordinates> value_by_primes(const PolynomialMap& map, const ClearedArguments& arguments,
                                           Construction construction) {
    const HomogeneousForm form(map);
    const std::vector<HomogeneousPair<Integer>> pairs =
        form.local(std::span<const HomogeneousPair<Integer>>(arguments.pairs));
    const std::vector<SubsetGroup> groups = groups_of(pairs);
    const auto rows = form.rows();
    std::optional<std::vector<Integer>> sums = construction == Construction::polarization
                                                   ? strict_subset_sums(rows, groups)
                                                   : regrouped_subset_sums(rows, groups);
    if (!sums) return std::nullopt;
    return reduced({*std::move(sums), factorial(pairs.size()) * form.denominator()}, arguments.denominator());
}

}  // namespace

std::size_t polarization_terms(std::span<const std::size_t> multiplicities, std::size_t limit) {
    std::size_t terms = 1;
    for (const std::size_t multiplicity : multiplicities) {
        if (terms > limit / (multiplicity + 1)) return limit + 1;
        terms *= multiplicity + 1;
    }
    return terms;
}

std::vector<std::size_t> multiplicities(const PatchArguments& arguments) {
    std::vector<std::size_t> counts;
    for (const auto& list : arguments) {
        const auto own = multiplicities(std::span<const Coordinates>(list));
        counts.insert(counts.end(), own.begin(), own.end());
    }
    return counts;
}

void require_terms_of_polarization(std::span<const std::size_t> multiplicities, const Limits& limits) {
    require_within(polarization_terms(multiplicities, limits.polarization_terms), limits.polarization_terms,
                   "polarization_terms", "the number of terms of polarization, at least", Part::arguments);
}

std::size_t regrouping_work(std::size_t n, std::size_t limit) {
    const Integer work = (Integer(n) * Integer(n + 1) / 2) * (Integer(n) * Integer(n + 1) / 2);
    return work > Integer(limit) ? limit + 1 : static_cast<std::size_t>(*work.to_int64());
}

Coordinates polarization_value(const PolynomialMap& map, std::span<const Argument> arguments,
                               Construction construction, const Limits& limits) {
    if (!std::ranges::all_of(arguments, is_point_or_vector)) {
        Coordinates value = polarization_value(map, with_unit_masses(arguments), construction, limits);
        const Rational factor = product_of_masses(arguments);
        for (Rational& coordinate : value) coordinate *= factor;
        return value;
    }
    const ClearedArguments cleared = cleared_one_by_one(arguments);
    const std::span<const HomogeneousPair<Integer>> pairs = cleared.pairs;
    require_result_bits(numerator_bits(map) + cleared.bits + arguments.size() * frame_bits(map), limits);
    bool by_primes = true;
    if (construction == Construction::polarization) {
        require_terms_of_polarization(multiplicities(pairs), limits);
        by_primes =
            polarization_terms(multiplicities(pairs), fewest_terms_by_primes) > fewest_terms_by_primes;
    } else {
        require_within(regrouping_work(arguments.size(), limits.regrouping_work), limits.regrouping_work,
                       "regrouping_work", "the number of multiply-adds of a regrouped polarization, at least",
                       Part::arguments);
    }
    if (by_primes) {
        if (auto value = value_by_primes(map, cleared, construction)) return *std::move(value);
    }
    PatchArguments tuples(1);
    for (const Argument& argument : arguments) tuples[0].push_back({argument.u, argument.mass});
    const IntegerArguments together = cleared_together(tuples, 0, limits);
    std::vector<HomogeneousPair<Integer>> sums_stay_integers;
    for (const Tuple<Integer>& pair : together.tuples[0]) sums_stay_integers.push_back({pair[0], pair[1]});
    return reduced(run_construction(map, construction, sums_stay_integers, limits), together.denominator);
}

}  // namespace blossom

#include <blossom/rational/resource_budget.hpp>

#include "subset_residues.hpp"

namespace blossom::subset_sums {

namespace {

/// The sub-multisets of some groups as a list: each is an earlier one and one more argument.
struct SubsetList {
    struct Entry {
        std::size_t smaller;  ///< the index of that earlier one; the first entry is the empty set
        std::size_t group;
        std::size_t points;
        Integer weight;  ///< prod (-1)^(m_i - j_i) C(m_i, j_i)
    };
    std::vector<Entry> entries;

    explicit SubsetList(Groups groups) {
        entries.push_back({0, 0, 0, 1});
        for (std::size_t g = 0; g < groups.size(); ++g) {
            const std::size_t m = groups[g].multiplicity;
            const std::size_t size = entries.size();
            for (std::size_t i = 0; i < size; ++i) {
                const Integer weight = entries[i].weight;
                Integer binomial = m % 2 == 0 ? 1 : -1;
                entries[i].weight *= binomial;
                for (std::size_t j = 1; j <= m; ++j) {
                    binomial = divide_exactly(binomial * -Integer(m - j + 1), Integer(j));
                    const std::size_t smaller = j == 1 ? i : entries.size() - 1;
                    const std::size_t points = entries[smaller].points + (groups[g].mass.is_zero() ? 0 : 1);
                    entries.push_back({smaller, g, points, weight * binomial});
                }
            }
        }
    }
};

/// The most sub-multisets that are laid out in lanes; those of the other groups are enumerated.
constexpr std::size_t most_lined_up = 512;

/// The part that does not depend on the primes: the enumerated groups, and the sets laid out in lanes.
struct StrictPlan {
    explicit StrictPlan(Groups given) : groups(given), in_front(given.size()) {
        std::size_t size = 1;
        while (in_front > 0 && size * (groups[in_front - 1].multiplicity + 1) <= most_lined_up)
            size *= groups[--in_front].multiplicity + 1;
        front.emplace(groups.first(in_front));
        behind.emplace(groups.subspan(in_front));
        // Each vector holds sets with the same number of points; empty lanes have an index past the end.
        std::size_t most_points = 0;
        for (const auto& entry : behind->entries) most_points = std::max(most_points, entry.points);
        for (std::size_t points = 0; points <= most_points; ++points) {
            const std::size_t begin = places.size();
            for (std::size_t i = 0; i < behind->entries.size(); ++i)
                if (behind->entries[i].points == points) places.push_back(i);
            while (places.size() % residues::lanes != 0) places.push_back(behind->entries.size());
            points_of_vector.resize(points_of_vector.size() + (places.size() - begin) / residues::lanes,
                                    points);
        }
    }

    Groups groups;
    std::size_t in_front;
    std::optional<SubsetList> front;
    std::optional<SubsetList> behind;
    std::vector<std::size_t> places;
    std::vector<std::size_t> points_of_vector;
};

/// One lane of a group of primes, repeated in all lanes.
Moduli broadcast(const Moduli& group, std::size_t lane) {
    Moduli result = group;
    for (ResidueVector Moduli::* vector :
         {&Moduli::prime, &Moduli::delta, &Moduli::inverse, &Moduli::radix, &Moduli::square, &Moduli::root})
        std::ranges::fill((result.*vector).lane, (group.*vector).lane[lane]);
    return result;
}

/// The sums modulo one prime.
class StrictResidue {
public:
    StrictResidue(const StrictPlan& plan, const Moduli& group, std::size_t lane)
        : plan_(plan), moduli_(broadcast(group, lane)), field_(group.prime.lane[lane]) {}

    /// Returns nullopt if the prime divides the mass of a point.
    std::optional<std::vector<std::uint64_t>> sums(Rows rows) {
        std::vector<std::uint64_t> parameters;
        std::uint64_t masses = 1;
        for (const SubsetGroup& group : plan_.groups) {
            const auto residue = group_residue(field_, group);
            if (!residue) return std::nullopt;
            parameters.push_back(in_montgomery_form(residue->parameter));
            masses = field_.product(masses, field_.power(residue->mass, group.multiplicity));
        }
        const std::span<const std::uint64_t> all = parameters;
        const std::vector<std::uint64_t> front = parameters_of(*plan_.front, all.first(plan_.in_front));
        const std::vector<std::uint64_t> behind = parameters_of(*plan_.behind, all.subspan(plan_.in_front));
        std::vector<ResidueVector> offsets(plan_.points_of_vector.size());
        for (std::size_t i = 0; i < plan_.places.size(); ++i) {
            const std::size_t place = plan_.places[i];
            offsets[i / residues::lanes].lane[i % residues::lanes] =
                place < behind.size() ? behind[place] : 0;
        }
        std::vector<std::uint64_t> result;
        for (const auto row : rows) result.push_back(field_.product(masses, sum(row, front, offsets)));
        return result;
    }

private:
    std::uint64_t in_montgomery_form(std::uint64_t value) const {
        return field_.product(value, moduli_.radix.lane[0]);
    }

    std::vector<std::uint64_t> parameters_of(const SubsetList& list,
                                             std::span<const std::uint64_t> parameters) const {
        std::vector<std::uint64_t> sums(list.entries.size());
        for (std::size_t i = 1; i < sums.size(); ++i) {
            const SubsetList::Entry& entry = list.entries[i];
            sums[i] = field_.sum(sums[entry.smaller], parameters[entry.group]);
        }
        return sums;
    }

    /// c_k N^(n-k) + p, highest k first, for each number N of points.
    std::vector<std::uint64_t> coefficients(std::span<const Integer> row) const {
        std::vector<std::uint64_t> residues;
        for (const Integer& coefficient : row) residues.push_back(field_.of(coefficient));
        std::vector<std::uint64_t> table;
        for (std::size_t points = 0; points < row.size(); ++points) {
            std::uint64_t power = 1;
            for (std::size_t k = row.size(); k-- > 0;) {
                table.push_back(field_.product(residues[k], power) + field_.prime());
                power = field_.product(power, points);
            }
        }
        return table;
    }

    std::uint64_t sum(std::span<const Integer> row, std::span<const std::uint64_t> front,
                      std::span<const ResidueVector> offsets) const {
        const std::vector<std::uint64_t> table = coefficients(row);
        std::vector<const std::uint64_t*> rows(offsets.size());
        std::vector<ResidueVector> sums(offsets.size());
        std::ranges::fill(sums, residue_vector_of(0));
        for (std::size_t i = 0; i < front.size(); ++i) {
            const SubsetList::Entry& entry = plan_.front->entries[i];
            spend_work(offsets.size() * residues::lanes * row.size());
            for (std::size_t o = 0; o < offsets.size(); ++o)
                rows[o] = table.data() + (entry.points + plan_.points_of_vector[o]) * row.size();
            const std::uint64_t weight = in_montgomery_form(field_.of(entry.weight));
            operations().add_values(moduli_, rows.data(), row.size(), residue_vector_of(front[i]),
                                    offsets.data(), residue_vector_of(weight), offsets.size(), sums.data());
        }
        std::uint64_t total = 0;
        for (std::size_t i = 0; i < plan_.places.size(); ++i) {
            const std::size_t place = plan_.places[i];
            if (place == plan_.behind->entries.size()) continue;
            const std::uint64_t weight = field_.of(plan_.behind->entries[place].weight);
            const std::uint64_t value = sums[i / residues::lanes].lane[i % residues::lanes] % field_.prime();
            total = field_.sum(total, field_.product(weight, value));
        }
        return total;
    }

    const StrictPlan& plan_;
    Moduli moduli_;
    PrimeField field_;
};

/// For larger results, the conversions to and from residues take longer than arithmetic on large integers.
constexpr std::size_t most_strict_bits = 100'000;

/// Integers from an increasing number of residues. Primes are taken one at a time, because each of them costs
/// all terms again; a prime that divides a mass is skipped.
class GrowingResidues {
public:
    explicit GrowingResidues(std::size_t count) : values_(count) {}

    std::size_t bits() const { return modulus_.bit_length() - 1; }

    void append(const PrimeField& field, std::span<const std::uint64_t> residues) {
        const std::uint64_t inverse = field.inverse(field.of(modulus_));
        for (std::size_t i = 0; i < values_.size(); ++i) {
            const std::uint64_t difference = field.sum(residues[i], field.prime() - field.of(values_[i]));
            values_[i].add_product(modulus_, field.product(difference, inverse));
        }
        modulus_ *= field.prime();
    }
    std::vector<Integer> values() && {
        const Integer half = modulus_ >> 1;
        for (Integer& value : values_)
            if (value > half) value -= modulus_;
        return std::move(values_);
    }

private:
    std::vector<Integer> values_;
    Integer modulus_ = 1;
};

std::optional<std::vector<Integer>> strict(Rows rows, Groups groups) {
    const std::size_t bits = result_bits(rows, groups) + 1;
    if (bits > most_strict_bits) return std::nullopt;
    const StrictPlan plan(groups);
    GrowingResidues result(rows.size());
    for (std::size_t i = 0; result.bits() < bits; ++i) {
        StrictResidue prime(plan, moduli(i / residues::lanes), i % residues::lanes);
        if (const auto residues = prime.sums(rows))
            result.append(PrimeField(moduli(i / residues::lanes).prime.lane[i % residues::lanes]), *residues);
    }
    return std::move(result).values();
}

}  // namespace

}  // namespace blossom::subset_sums

namespace blossom {

std::optional<std::vector<Integer>> strict_subset_sums(subset_sums::Rows rows, subset_sums::Groups groups) {
    return subset_sums::strict(rows, groups);
}

}  // namespace blossom

#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/subset_sums.hpp>

#include <algorithm>

#include "prime_field.hpp"
#include "residue_system.hpp"

namespace blossom {

namespace {

using residues::lanes;
using residues::Moduli;
using residues::moduli;
using residues::Octet;
using residues::operations;

using Rows = std::span<const std::span<const Integer>>;
using Groups = std::span<const SubsetGroup>;

std::size_t number_of_arguments(Groups groups) {
    std::size_t n = 0;
    for (const SubsetGroup& group : groups) n += group.multiplicity;
    return n;
}

/// A bound in bits on n! p(arguments): |p| <= max |c_k| prod (|mass_i| + |u_i|).
std::size_t result_bits(Rows rows, Groups groups) {
    std::size_t bits = 0;
    for (const auto row : rows)
        for (const Integer& coefficient : row) bits = std::max(bits, coefficient.bit_length());
    for (const SubsetGroup& group : groups)
        bits += group.multiplicity * (abs(group.u) + abs(group.mass)).bit_length();
    return bits + factorial(number_of_arguments(groups)).bit_length();
}

/// A group modulo a prime: the point u / mass, or the vector u.
struct GroupResidue {
    std::uint64_t parameter;
    std::uint64_t mass;  ///< 1 for a vector
};

/// Nothing if the prime divides the mass of a point.
std::optional<GroupResidue> group_residue(const PrimeField& field, const SubsetGroup& group) {
    const std::uint64_t u = field.of(group.u);
    if (group.mass.is_zero()) return GroupResidue{u, 1};
    const std::uint64_t mass = field.of(group.mass);
    if (mass == 0) return std::nullopt;
    return GroupResidue{field.product(u, field.inverse(mass)), mass};
}

// ---- every term

/// The sub-multisets of some groups as a list: each is an earlier one with one argument more.
struct SubsetList {
    struct Entry {
        std::size_t smaller;  ///< its index; the first entry is the empty set
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

/// How many sub-multisets at most are lined up for the lanes; those of the other groups are taken in turn.
constexpr std::size_t most_lined_up = 512;

/// What is the same for all primes: the groups in front, taken in turn, and those behind, lined up.
struct StrictPlan {
    explicit StrictPlan(Groups given) : groups(given), in_front(given.size()) {
        std::size_t size = 1;
        while (in_front > 0 && size * (groups[in_front - 1].multiplicity + 1) <= most_lined_up)
            size *= groups[--in_front].multiplicity + 1;
        front.emplace(groups.first(in_front));
        behind.emplace(groups.subspan(in_front));
        // In octets of entries with the same number of points; a place for none has the last index and one.
        std::size_t most_points = 0;
        for (const auto& entry : behind->entries) most_points = std::max(most_points, entry.points);
        for (std::size_t points = 0; points <= most_points; ++points) {
            const std::size_t begin = places.size();
            for (std::size_t i = 0; i < behind->entries.size(); ++i)
                if (behind->entries[i].points == points) places.push_back(i);
            while (places.size() % lanes != 0) places.push_back(behind->entries.size());
            points_of_octet.resize(points_of_octet.size() + (places.size() - begin) / lanes, points);
        }
    }

    Groups groups;
    std::size_t in_front;
    std::optional<SubsetList> front;
    std::optional<SubsetList> behind;
    std::vector<std::size_t> places;
    std::vector<std::size_t> points_of_octet;
};

/// One lane of a group of primes, in all lanes.
Moduli broadcast(const Moduli& group, std::size_t lane) {
    Moduli result = group;
    for (Octet Moduli::* octet :
         {&Moduli::prime, &Moduli::delta, &Moduli::inverse, &Moduli::radix, &Moduli::square, &Moduli::root})
        std::ranges::fill((result.*octet).lane, (group.*octet).lane[lane]);
    return result;
}

Octet octet_of(std::uint64_t value) {
    Octet result{};
    std::ranges::fill(result.lane, value);
    return result;
}

/// The sums modulo one prime.
class StrictResidue {
public:
    StrictResidue(const StrictPlan& plan, const Moduli& group, std::size_t lane)
        : plan_(plan), moduli_(broadcast(group, lane)), field_(group.prime.lane[lane]) {}

    /// Nothing if the prime divides the mass of a point.
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
        std::vector<Octet> offsets(plan_.points_of_octet.size());
        for (std::size_t i = 0; i < plan_.places.size(); ++i) {
            const std::size_t place = plan_.places[i];
            offsets[i / lanes].lane[i % lanes] = place < behind.size() ? behind[place] : 0;
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
                      std::span<const Octet> offsets) const {
        const std::vector<std::uint64_t> table = coefficients(row);
        std::vector<const std::uint64_t*> rows(offsets.size());
        std::vector<Octet> sums(offsets.size());
        std::ranges::fill(sums, octet_of(0));
        for (std::size_t i = 0; i < front.size(); ++i) {
            const SubsetList::Entry& entry = plan_.front->entries[i];
            for (std::size_t o = 0; o < offsets.size(); ++o)
                rows[o] = table.data() + (entry.points + plan_.points_of_octet[o]) * row.size();
            const std::uint64_t weight = in_montgomery_form(field_.of(entry.weight));
            operations().add_values(moduli_, rows.data(), row.size(), octet_of(front[i]), offsets.data(),
                                    octet_of(weight), offsets.size(), sums.data());
        }
        std::uint64_t total = 0;
        for (std::size_t i = 0; i < plan_.places.size(); ++i) {
            const std::size_t place = plan_.places[i];
            if (place == plan_.behind->entries.size()) continue;
            const std::uint64_t weight = field_.of(plan_.behind->entries[place].weight);
            const std::uint64_t value = sums[i / lanes].lane[i % lanes] % field_.prime();
            total = field_.sum(total, field_.product(weight, value));
        }
        return total;
    }

    const StrictPlan& plan_;
    Moduli moduli_;
    PrimeField field_;
};

/// Integers by more and more residues, each of least magnitude.
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

}  // namespace

std::vector<Integer> strict_subset_sums(Rows rows, Groups groups) {
    const StrictPlan plan(groups);
    const std::size_t bits = result_bits(rows, groups) + 1;
    GrowingResidues result(rows.size());
    for (std::size_t i = 0; result.bits() < bits; ++i) {
        StrictResidue prime(plan, moduli(i / lanes), i % lanes);
        if (const auto residues = prime.sums(rows))
            result.append(PrimeField(moduli(i / lanes).prime.lane[i % lanes]), *residues);
    }
    return std::move(result).values();
}

// ---- power sums

namespace {

/// a_Nk = sum (-1)^(n-|S|) (sum of S)^k / k! over the sub-multisets S with N points, modulo eight primes.
class PowerSums {
public:
    PowerSums(const Moduli& moduli, std::size_t n)
        : moduli_(moduli), size_(n + 1), sums_(size_ * size_), powers_(size_), inverse_(size_) {
        std::ranges::fill(sums_, octet_of(0));
        sums_[0] = octet_of(1);
        for (std::size_t l = 0; l < lanes; ++l) {
            const PrimeField field(moduli.prime.lane[l]);
            for (std::size_t j = 1; j < size_; ++j)
                inverse_[j].lane[l] = field.product(field.inverse(j), moduli.square.lane[l]);
        }
    }

    /// One more argument: sets without it change sign, and e^((u + x) t) = e^(u t) e^(x t) for those with it.
    void append(const Octet& parameter, bool point) {
        // x^j / j! behind all others, highest j first, times the radix.
        Octet factor{};
        powers_[size_ - 1] = moduli_.radix;
        for (std::size_t j = 1; j < size_; ++j) {
            operations().scale(moduli_, &parameter, inverse_[j], 1, &factor);
            operations().scale(moduli_, &powers_[size_ - j], factor, 1, &powers_[size_ - 1 - j]);
        }
        points_ += point ? 1 : 0;
        const Octet zero = octet_of(0);
        for (std::size_t points = points_ + 1; points-- > 0;) {
            Octet* row = sums_.data() + points * size_;
            const bool grows = !point || points > 0;
            const Octet* smaller = point && grows ? row - size_ : row;
            for (std::size_t k = size_; k-- > 0;) {
                const Octet larger =
                    grows ? operations().dot(moduli_, smaller, &powers_[size_ - 1 - k], k + 1) : zero;
                operations().subtract(moduli_, &larger, &row[k], 1, &row[k]);
            }
        }
    }

    /// sum_N N^(n-k) a_Nk for each k.
    std::vector<Octet> weighted_by_points() const {
        std::vector<Octet> result(size_, octet_of(0));
        for (std::size_t points = 0; points <= points_; ++points) {
            Octet number{};
            for (std::size_t l = 0; l < lanes; ++l)
                number.lane[l] = PrimeField(moduli_.prime.lane[l]).product(points, moduli_.radix.lane[l]);
            Octet power = moduli_.radix;
            for (std::size_t k = size_; k-- > 0;) {
                Octet term{};
                operations().scale(moduli_, &sums_[points * size_ + k], power, 1, &term);
                operations().add(moduli_, &result[k], &term, 1, &result[k]);
                operations().scale(moduli_, &power, number, 1, &power);
            }
        }
        return result;
    }

private:
    const Moduli& moduli_;
    std::size_t size_;
    std::size_t points_ = 0;
    std::vector<Octet> sums_;  ///< row after row, one for each number of points
    std::vector<Octet> powers_;
    std::vector<Octet> inverse_;  ///< 1/j times the square of the radix
};

}  // namespace

std::optional<std::vector<Integer>> regrouped_subset_sums(Rows rows, Groups groups) {
    const std::size_t n = number_of_arguments(groups);
    std::vector<std::vector<Octet>> residues_of_sums(rows.size());
    const std::size_t prime_groups = residues::groups_for(result_bits(rows, groups));
    for (std::size_t g = 0; g < prime_groups; ++g) {
        const Moduli& primes = moduli(g);
        PowerSums sums(primes, n);
        Octet masses = octet_of(1);
        for (const SubsetGroup& group : groups) {
            Octet parameter{};
            for (std::size_t l = 0; l < lanes; ++l) {
                const PrimeField field(primes.prime.lane[l]);
                const auto residue = group_residue(field, group);
                if (!residue) return std::nullopt;
                parameter.lane[l] = residue->parameter;
                masses.lane[l] =
                    field.product(masses.lane[l], field.power(residue->mass, group.multiplicity));
            }
            for (std::size_t i = 0; i < group.multiplicity; ++i)
                sums.append(parameter, !group.mass.is_zero());
        }
        const std::vector<Octet> weighted = sums.weighted_by_points();
        for (std::size_t j = 0; j < rows.size(); ++j) {
            Octet total = octet_of(0);
            for (std::size_t l = 0; l < lanes; ++l) {
                const PrimeField field(primes.prime.lane[l]);
                std::uint64_t factor = masses.lane[l];  // times k!
                for (std::size_t k = 0; k <= n; ++k) {
                    if (k > 0) factor = field.product(factor, k);
                    const std::uint64_t coefficient = field.product(field.of(rows[j][k]), factor);
                    total.lane[l] = field.sum(
                        total.lane[l], field.product(coefficient, weighted[k].lane[l] % field.prime()));
                }
            }
            residues_of_sums[j].push_back(total);
        }
    }
    std::vector<Integer> result;
    result.reserve(rows.size());
    for (const auto& residues : residues_of_sums) result.push_back(residues::integer_with(residues));
    return result;
}

}  // namespace blossom

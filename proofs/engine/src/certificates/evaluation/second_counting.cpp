#include "second_counting.hpp"

#include <blossom/rational/combinatorics.hpp>
#include <blossom/rational/error.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <utility>

namespace blossom::proofs::second {

void WorkLimit::exceeded(const char* name, std::size_t limit) {
    throw limit_error("the evaluation exceeds", name, limit);
}

void require_short_product(const Rational& a, const Rational& b, const Limits& limits) {
    if (a.numerator().is_word() && a.denominator().is_word()) return;
    const std::size_t bits = a.numerator().bit_length() + a.denominator().bit_length() +
                             b.numerator().bit_length() + b.denominator().bit_length();
    require_within(bits / 4, limits.digits, "digits", "the digits of a product");
}

Rational integer_power(const Rational& base, const Rational& exponent, const Limits& limits,
                       std::size_t offset) {
    const std::optional<std::int64_t> power = exponent.numerator().to_int64();
    if (!exponent.is_integer() || !power) {
        throw Error(ErrorCode::wrong_kind, "the exponent " + to_string(exponent) + " is no small integer", {},
                    offset);
    }
    const auto size = static_cast<std::size_t>(*power < 0 ? -*power : *power);
    require_within(size, limits.degree, "degree", "the exponent");
    const std::size_t bits = std::max(base.numerator().bit_length(), base.denominator().bit_length());
    require_within(bits * size / 4, limits.digits, "digits", "the digits of a power");
    return *power < 0 ? Rational(1) / pow(base, size) : pow(base, size);
}

std::string name_of_member(const std::string& family, const std::vector<long long>& indices) {
    if (indices.size() == 1 && indices.front() >= 0) return family + "_" + std::to_string(indices.front());
    std::string name = family + "_{";
    for (std::size_t i = 0; i < indices.size(); ++i) {
        if (i > 0) name += ',';
        name += std::to_string(indices[i]);
    }
    return name + "}";
}

Counting::Counting(const Reading& reading, std::vector<long long> parameters)
    : reading_(reading), parameters_(std::move(parameters)), work_(reading.limits()) {}

// Known values of abbreviations hold only for one choice of all parameters.
void Counting::push_parameter(long long value) {
    parameters_.push_back(value);
    known_.clear();
}

void Counting::pop_parameter() {
    parameters_.pop_back();
    known_.clear();
}

Rational Counting::value(NodeId id, Scope& scope) {
    const Node& node = reading_.node(id);
    const WorkLimit::Level level(work_);
    switch (node.form) {
        case Form::number:
            return node.value;
        case Form::name:
            if (node.meaning == Meaning::local) return scope[node.target].integer;
            if (node.meaning == Meaning::parameter && node.target < parameters_.size()) {
                return parameters_[node.target];
            }
            if (node.meaning == Meaning::abbreviation) return abbreviation(node, scope);
            break;
        case Form::member:
            return abbreviation(node, scope);
        case Form::terms: {
            Rational total;
            for (std::size_t i = 0; i < node.children.size(); ++i) {
                const Rational term = value(node.children[i], scope);
                node.flags[i] ? total -= term : total += term;
            }
            return total;
        }
        case Form::factors: {
            Rational total(1);
            for (std::size_t i = 0; i < node.children.size(); ++i) {
                const Rational factor = value(node.children[i], scope);
                require_short_product(total, factor, reading_.limits());
                node.flags[i] ? total /= factor : total *= factor;
            }
            return total;
        }
        case Form::negation:
            return -value(node.children[0], scope);
        case Form::power:
            return integer_power(value(node.children[0], scope), value(node.children[1], scope),
                                 reading_.limits(), node.offset);
        case Form::sum:
        case Form::product:
        case Form::mean:
            return iteration(node, scope);
        case Form::choice:
            return value(node.children[holds(node.children[0], scope) ? 1 : 2], scope);
        default:
            return function(node, scope);
    }
    throw Error(ErrorCode::wrong_kind,
                quoted(reading_.name(node.text)) + " has no value where this integer is needed", {},
                node.offset);
}

Rational Counting::iteration(const Node& node, Scope& scope) {
    Rational total(node.form == Form::product ? 1 : 0);
    long long members = 0;
    each(node.children[0], node.slot, scope, [&] {
        const Rational member = value(node.children[1], scope);
        node.form == Form::product ? total *= member : total += member;
        ++members;
    });
    if (node.form != Form::mean) return total;
    if (members == 0) throw Error(ErrorCode::division_by_zero, "a mean of nothing", {}, node.offset);
    return total / Rational(members);
}

Rational Counting::abbreviation(const Node& node, Scope& scope) {
    std::vector<long long> key = integers(node.children, scope);
    Scope inner;
    const Clause* clause = fitting_clause(node.target, key, inner);
    if (clause == nullptr) {
        throw Error(
            ErrorCode::wrong_kind,
            name_of_member(reading_.name(node.text), key) + " has no value where this integer is needed", {},
            node.offset);
    }
    key.push_back(static_cast<long long>(node.target));
    const auto known = known_.find(key);
    if (known != known_.end()) return known->second;
    if (!in_work_.insert(key).second) {
        throw Error(ErrorCode::syntax, quoted(reading_.name(node.text)) + " is an abbreviation of itself", {},
                    node.offset);
    }
    const AtEnd forget([&] { in_work_.erase(key); });
    work_.require_few_abbreviations(in_work_.size());
    Rational found = value(clause->body, inner);
    return known_.emplace(key, std::move(found)).first->second;
}

Rational Counting::function(const Node& node, Scope& scope) {
    switch (node.form) {
        case Form::size: {
            const Node& set = reading_.node(node.children[0]);
            if (set.form == Form::name && set.meaning == Meaning::local && set.kind == Kind::set_of_sets) {
                return scope[set.target].sets->size();
            }
            return this->set(node.children[0], scope).size();
        }
        case Form::binomial: {
            const long long n = integer(node.children[0], scope);
            const long long k = integer(node.children[1], scope);
            if (n < 0)
                throw Error(ErrorCode::outside_domain, "a binomial of a negative number", {}, node.offset);
            require_within(static_cast<std::size_t>(n), reading_.limits().degree, "degree", "a binomial");
            if (k < 0 || k > n) return 0;
            return blossom::binomial(static_cast<std::size_t>(n), static_cast<std::size_t>(k));
        }
        case Form::factorial:
            return blossom::factorial(
                count(node.children[0], scope, reading_.limits().degree, "what a factorial is taken of"));
        case Form::image: {
            const IntegerSet& images = *scope[node.target].set;
            const long long place = integer(node.children[0], scope);
            if (place < 1 || place > static_cast<long long>(images.size())) {
                throw Error(ErrorCode::outside_domain,
                            "a permutation of 1.." + std::to_string(images.size()) + " has no image of " +
                                std::to_string(place),
                            {}, node.offset);
            }
            return images[static_cast<std::size_t>(place - 1)];
        }
        case Form::sign: {
            const IntegerSet& images = *scope[reading_.node(node.children[0]).target].set;
            bool odd = false;
            for (std::size_t i = 0; i < images.size(); ++i) {
                for (std::size_t j = 0; j < i; ++j) odd = odd != (images[j] > images[i]);
            }
            return odd ? -1 : 1;
        }
        default:
            throw Error(ErrorCode::wrong_kind, "an integer is expected here", {}, node.offset);
    }
}

long long Counting::integer(NodeId id, Scope& scope) {
    const Node& node = reading_.node(id);
    if (node.form == Form::name && node.meaning == Meaning::local) return scope[node.target].integer;
    const Rational found = value(id, scope);
    // Leaves room for additions to the result without overflow.
    constexpr long long most = 1LL << 40;
    const std::optional<std::int64_t> word = found.numerator().to_int64();
    if (!found.is_integer() || !word || *word > most || *word < -most) {
        throw Error(ErrorCode::wrong_kind, to_string(found) + " is no integer that counts", {}, node.offset);
    }
    return *word;
}

std::size_t Counting::count(NodeId id, Scope& scope, std::size_t limit, const char* what) {
    const long long found = integer(id, scope);
    if (found < 0) {
        throw Error(ErrorCode::outside_domain, std::string(what) + " is negative, " + std::to_string(found),
                    {}, reading_.node(id).offset);
    }
    require_within(static_cast<std::size_t>(found), limit, "degree", what);
    return static_cast<std::size_t>(found);
}

std::vector<long long> Counting::integers(const std::vector<NodeId>& ids, Scope& scope) {
    std::vector<long long> found;
    found.reserve(ids.size() + 1);
    for (const NodeId id : ids) found.push_back(integer(id, scope));
    return found;
}

bool Counting::holds(NodeId condition, Scope& scope) {
    const Node& node = reading_.node(condition);
    if (node.form == Form::membership) {
        const long long member = integer(node.children[0], scope);
        const bool contained = std::ranges::binary_search(set(node.children[1], scope), member);
        return contained == (node.relation == Relation::equal);
    }
    const Rational left = value(node.children[0], scope);
    const Rational right = value(node.children[1], scope);
    switch (node.relation) {
        case Relation::equal:
            return left == right;
        case Relation::different:
            return left != right;
        case Relation::less:
            return left < right;
        case Relation::less_or_equal:
            return left <= right;
        case Relation::greater:
            return left > right;
        case Relation::greater_or_equal:
            return left >= right;
    }
    return false;
}

}  // namespace blossom::proofs::second

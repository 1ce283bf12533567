#include <fmt/format.h>
#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <map>
#include <optional>

#include "fields.hpp"
#include "proof_certificate.hpp"
#include "proof_terms.hpp"

/// The checker of certificates. Slow and plain on purpose: the blossom is the sum over all ways to choose a
/// monomial from the arguments.

namespace blossom::cli {

namespace proof_terms {

namespace {

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorCode::syntax, message); }

std::size_t index(const Json& value, std::size_t below) {
    const std::size_t read = read_count(value, Limits{});
    if (read >= below) refuse(fmt::format("the number {} is not below {}", read, below));
    return read;
}

Terms read_terms(const Json& value, std::size_t symbols) {
    Terms terms;
    for (const Json& term : read_array(value)) {
        const Json::Array& parts = read_array(term);
        if (parts.empty()) refuse("a term without a coefficient");
        Monomial monomial;
        for (std::size_t i = 1; i < parts.size(); ++i) {
            const Json::Array& factor = read_array(parts[i]);
            if (factor.size() != 2) refuse("a factor is a symbol and its exponent");
            monomial[index(factor[0], symbols)] = read_count(factor[1], Limits{});
        }
        add(terms, Terms{{monomial, read_number(parts[0], Limits{})}});
    }
    return terms;
}

struct CheckedMap {
    struct Direction {
        std::size_t degree;
        std::size_t dimension;
    };
    std::vector<Direction> directions;
    std::vector<std::size_t> coefficients;
};

/// The exponents of the monomials of one direction, in the order of its coefficients.
std::vector<std::vector<std::size_t>> exponents_of(std::size_t dimension, std::size_t degree) {
    if (dimension == 0) return {{}};
    std::vector<std::vector<std::size_t>> list;
    for (std::size_t first = 0; first <= degree; ++first) {
        for (std::vector<std::size_t> rest : exponents_of(dimension - 1, degree - first)) {
            rest.insert(rest.begin(), first);
            list.push_back(std::move(rest));
        }
    }
    return list;
}

class Entry {
public:
    explicit Entry(const Json& entry) : entry_(entry) {
        symbols_ = read_array(member("symbols")).size();
        for (const Json& map : read_array(member("maps"))) read_map(map);
    }

    /// Empty when the entry is a proof.
    std::string problem() {
        const Json::Array& nodes = read_array(member("nodes"));
        for (const Json& node : nodes) values_.push_back(value_of(read_array(node)));
        const Quotient& left = values_[index(member("left"), values_.size())];
        const Quotient& right = values_[index(member("right"), values_.size())];
        Quotient form{read_terms(member("numerator"), symbols_), {}};
        for (const Json& factor : read_array(member("denominator"))) {
            const Json::Array& parts = read_array(factor);
            if (parts.size() != 2) refuse("a factor is a polynomial and its exponent");
            form.divisors[read_terms(parts[0], symbols_)] += read_count(parts[1], Limits{});
        }
        if (form.divisors.contains(Terms{})) return "a factor of the denominator is zero";
        if (!sum_of(left, negated(form)).numerator.empty()) return "the left side has another normal form";
        solve();
        if (!reduced(sum_of(left, negated(right)).numerator).empty()) return "the two sides differ";
        return "";
    }

private:
    const Json& member(std::string_view name) const {
        const Json* found = entry_.find(name);
        if (!found) throw Error(ErrorCode::missing_field, fmt::format("an entry has no \"{}\"", name));
        return *found;
    }

    void read_map(const Json& map) {
        CheckedMap result;
        const Json* directions = map.find("directions");
        const Json* coefficients = map.find("coefficients");
        if (!directions || !coefficients) refuse("a map has directions and coefficients");
        std::size_t expected = 1;
        for (const Json& direction : read_array(*directions)) {
            const Json::Array& parts = read_array(direction);
            if (parts.size() != 2) refuse("a direction is a degree and a dimension");
            result.directions.push_back({index(parts[0], 1000), index(parts[1], 20)});
            expected *=
                exponents_of(result.directions.back().dimension, result.directions.back().degree).size();
        }
        for (const Json& coefficient : read_array(*coefficients))
            result.coefficients.push_back(read_count(coefficient, Limits{.degree = 1 << 24}));
        if (result.coefficients.size() != expected) refuse("a map with a wrong number of coefficients");
        maps_.push_back(std::move(result));
    }

    const Quotient& operand(const Json& value) const { return values_[index(value, values_.size())]; }

    Quotient value_of(const Json::Array& node) {
        if (node.size() < 2 || !node[0].text()) refuse("a node is its kind and its operands");
        const std::string& kind = *node[0].text();
        if (kind == "constant") return {number(read_number(node[1], Limits{})), {}};
        if (kind == "symbol") return {Terms{{Monomial{{index(node[1], symbols_), 1}}, 1}}, {}};
        if (kind == "blossom" || kind == "value") return application(node);
        Quotient result = operand(node[1]);
        if (kind == "power") {
            if (node.size() != 3) refuse("a power has a base and an exponent");
            const std::size_t exponent = read_count(node[2], Limits{});
            result.numerator = power(result.numerator, exponent);
            for (auto& [divisor, times] : result.divisors) times *= exponent;
            return result;
        }
        for (std::size_t i = 2; i < node.size(); ++i) {
            const Quotient& next = operand(node[i]);
            if (kind == "sum") {
                result = sum_of(result, next);
            } else if (kind == "product") {
                result = product_of(result, next);
            } else if (kind == "quotient") {
                if (next.numerator.empty()) refuse("a division by zero");
                result = quotient_of(result, next);
            } else {
                refuse(fmt::format("a node of the unknown kind {}", quoted(kind)));
            }
        }
        return result;
    }

    /// Each argument as its coordinates and its mass.
    using Argument = std::vector<Quotient>;

    Quotient application(const Json::Array& node) {
        const bool polar = *node[0].text() == "blossom";
        if (node.size() != (polar ? 3U : 4U)) refuse("an application with missing parts");
        const CheckedMap& map = maps_[index(node[1], maps_.size())];
        std::vector<std::vector<Argument>> arguments;
        for (const Json& direction : read_array(node.back())) {
            arguments.emplace_back();
            for (const Json& argument : read_array(direction)) {
                arguments.back().emplace_back();
                for (const Json& entry : read_array(argument))
                    arguments.back().back().push_back(operand(entry));
            }
        }
        if (arguments.size() != map.directions.size()) refuse("an application with missing directions");
        std::vector<Quotient> coefficients;
        for (const std::size_t coefficient : map.coefficients) {
            if (coefficient >= values_.size()) refuse("a coefficient that comes too late");
            coefficients.push_back(values_[coefficient]);
        }
        for (std::size_t i = map.directions.size(); i-- > 0;) {
            const auto& [degree, dimension] = map.directions[i];
            const std::size_t order = polar ? 0 : read_count(read_array(node[2]).at(i), Limits{});
            std::vector<Argument> all = arguments[i];
            if (!polar) {
                if (all.size() != 1) refuse("a value has one argument a direction");
                all = with_derivative(all.front(), degree, order);
            }
            if (all.size() != degree && order <= degree)
                refuse("a blossom has as many arguments as the degree");
            Rational scale = 1;
            for (std::size_t j = 0; j < order; ++j) scale *= Rational(degree) - Rational(j);
            coefficients = contracted(coefficients, degree, dimension, all, scale);
        }
        return coefficients.front();
    }

    /// t^(n-k), delta^k.
    static std::vector<Argument> with_derivative(const Argument& t, std::size_t degree, std::size_t order) {
        if (order > degree) return {};
        std::vector<Argument> all(degree - order, t);
        all.insert(all.end(), order, Argument{Quotient{number(1), {}}, Quotient{number(0), {}}});
        return all;
    }

    /// One direction applied: each row of coefficients becomes sum c_alpha e_alpha(arguments) / multinomial.
    static std::vector<Quotient> contracted(const std::vector<Quotient>& coefficients, std::size_t degree,
                                            std::size_t dimension, const std::vector<Argument>& arguments,
                                            const Rational& scale) {
        const auto exponents = exponents_of(dimension, degree);
        // Choosing an entry of every argument in all ways, counted by what has been chosen.
        std::map<std::vector<std::size_t>, Quotient> chosen{
            {std::vector<std::size_t>(dimension, 0), Quotient{number(1), {}}}};
        for (const Argument& argument : arguments) {
            if (argument.size() != dimension + 1) refuse("an argument of another dimension");
            std::map<std::vector<std::size_t>, Quotient> next;
            for (const auto& [choice, product] : chosen) {
                for (std::size_t j = 0; j <= dimension; ++j) {
                    std::vector<std::size_t> longer = choice;
                    if (j < dimension) ++longer[j];
                    const Quotient further = product_of(product, argument[j]);
                    const auto known = next.find(longer);
                    if (known == next.end()) {
                        next.emplace(longer, further);
                    } else {
                        known->second = sum_of(known->second, further);
                    }
                }
            }
            chosen = std::move(next);
        }
        std::vector<Quotient> result;
        for (std::size_t row = 0; row < coefficients.size(); row += exponents.size()) {
            Quotient sum;
            for (std::size_t k = 0; k < exponents.size(); ++k) {
                const auto found = chosen.find(exponents[k]);
                if (found == chosen.end()) continue;
                Quotient term = product_of(coefficients[row + k], found->second);
                term.numerator = times(term.numerator, number(scale / multinomial(exponents[k], degree)));
                sum = sum_of(sum, term);
            }
            result.push_back(std::move(sum));
        }
        return result;
    }

    /// degree! / (alpha_1! ... alpha_s! (degree - |alpha|)!)
    static Rational multinomial(const std::vector<std::size_t>& exponents, std::size_t degree) {
        Rational result = 1;
        std::size_t left = degree;
        for (const std::size_t exponent : exponents) {
            for (std::size_t i = 1; i <= exponent; ++i) result *= Rational(left--, i);
        }
        return result;
    }

    /// Uses the hypotheses to express the symbols that are listed: any equation that holds may be solved for
    /// any symbol in which it is linear.
    void solve() {
        std::vector<Terms> equations;
        for (const Json& hypothesis : read_array(member("hypotheses"))) {
            const Json::Array& parts = read_array(hypothesis);
            if (parts.size() != 3) refuse("a hypothesis has two sides and its symbols");
            const Quotient difference = sum_of(operand(parts[0]), negated(operand(parts[1])));
            std::map<Monomial, Terms> coefficients;
            for (const auto& [monomial, coefficient] : difference.numerator) {
                Monomial key;
                Monomial rest = monomial;
                for (const Json& symbol : read_array(parts[2])) {
                    const auto found = rest.find(index(symbol, symbols_));
                    if (found != rest.end()) key.insert(rest.extract(found));
                }
                coefficients[key].emplace(rest, coefficient);
            }
            for (auto& [key, terms] : coefficients) equations.push_back(std::move(terms));
        }
        for (const Json& listed : read_array(member("solved"))) {
            const std::size_t symbol = index(listed, symbols_);
            bool found = false;
            for (const Terms& equation : equations) {
                const auto powers = by_powers(reduced(equation), symbol);
                if (powers.size() != 2) continue;
                solutions_.push_back({symbol, times(number(-1), powers[0]), powers[1]});
                found = true;
                break;
            }
            if (!found) refuse(fmt::format("no hypothesis gives symbol {}", symbol));
        }
    }

    static std::vector<Terms> by_powers(const Terms& terms, std::size_t symbol) {
        std::vector<Terms> powers;
        for (const auto& [monomial, coefficient] : terms) {
            Monomial rest = monomial;
            const auto found = rest.find(symbol);
            const std::size_t power = found == rest.end() ? 0 : found->second;
            if (found != rest.end()) rest.erase(found);
            if (powers.size() <= power) powers.resize(power + 1);
            powers[power].emplace(rest, coefficient);
        }
        return powers;
    }

    struct Solution {
        std::size_t symbol;
        Terms numerator;
        Terms denominator;
    };

    /// With the solutions in place of their symbols, times what keeps it a polynomial.
    Terms reduced(Terms terms) const {
        for (const auto& [symbol, numerator, denominator] : solutions_) {
            const auto powers = by_powers(terms, symbol);
            if (powers.size() <= 1) continue;
            Terms value;
            for (std::size_t k = 0; k < powers.size(); ++k) {
                add(value,
                    times(times(powers[k], power(numerator, k)), power(denominator, powers.size() - 1 - k)));
            }
            terms = std::move(value);
        }
        return terms;
    }

    const Json& entry_;
    std::size_t symbols_ = 0;
    std::vector<CheckedMap> maps_;
    std::vector<Quotient> values_;
    std::vector<Solution> solutions_;
};

}  // namespace

}  // namespace proof_terms

CertificateCheck check_certificate(const Json& certificate) {
    const Json* entries = certificate.find("proofs");
    const Json* seal = certificate.find("seal");
    if (!entries || !entries->array() || !seal || !seal->text()) {
        throw Error(ErrorCode::missing_field, "this is no certificate: it has no \"proofs\" or no \"seal\"");
    }
    CertificateCheck result;
    if (*seal->text() != seal_of(*entries)) result.problems.emplace_back("the seal is broken");
    for (std::size_t i = 0; i < entries->array()->size(); ++i) {
        const Json& entry = (*entries->array())[i];
        std::string problem;
        try {
            problem = proof_terms::Entry(entry).problem();
        } catch (const Error& error) {
            problem = error.message();
        } catch (const std::out_of_range&) {
            problem = "a list is too short";
        }
        const Json* id = entry.find("id");
        const std::string name = id && id->text() ? *id->text() : "";
        if (problem.empty()) {
            ++result.confirmed;
        } else {
            result.problems.push_back(fmt::format("proof {} ({}): {}", i, name, problem));
        }
    }
    return result;
}

}  // namespace blossom::cli

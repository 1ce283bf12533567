#include "certificate_checker.hpp"

#include "branch_state.hpp"
#include "certificates/evaluation/second_evaluation.hpp"
#include "certificates/symbolic/symbolic_field.hpp"

#include <blossom/rational/number_text.hpp>

#include <algorithm>
#include <set>
#include <utility>

namespace blossom::proofs::second {

namespace {

/// The polynomial in symbols of a field. Errors: `syntax` if it has more than `new_names` symbols that are
/// not in the field; if `new_names` is 0, for any symbols but the first `symbols` ones.
PlainPolynomial named_polynomial(const NamedPolynomial& named, SymbolicField& field, std::size_t symbols,
                                 std::size_t new_names) {
    std::set<std::string> others;
    field.budget().require_terms(named.size(), 0);
    std::vector<PlainPolynomial> terms;
    for (const NamedTerm& term : named) {
        field.budget().spend(1 + term.powers.size());
        std::vector<std::pair<std::size_t, std::size_t>> powers;
        for (const auto& [name, exponent] : term.powers) {
            if (exponent == 0) continue;
            const auto known = field.number_of(name);
            if (!known || (new_names == 0 && *known >= symbols)) {
                others.insert(name);
                if (others.size() > new_names) {
                    throw Error(ErrorCode::syntax, "there is no symbol " + quoted(name) + " in this case");
                }
            }
            powers.emplace_back(field.number_of_or_new(name), exponent);
        }
        terms.push_back(single_term(term.coefficient, powers));
        field.budget().require_terms(terms.size(), terms.back().width());
    }
    return sum_of(std::move(terms), field.budget());
}

/// One case of a claim as rational functions, and the walk through the branches of its certificate.
class CaseCheck {
public:
    CaseCheck(const Reading& reading, const Certificate& certificate, const Limits& limits)
        : certificate_(certificate), limits_(limits), field_(limits) {
        Evaluation<SymbolicField> evaluation(reading, certificate.which, field_);
        for (const auto& [first, second] : evaluation.hypotheses()) {
            const PlainPolynomial equation = field_.numerator(field_.sum(first, field_.negative(second)));
            for (PlainPolynomial& part :
                 coefficients_by_monomials(equation, field_.hidden_symbols(), field_.budget())) {
                equations_.push_back(std::move(part));
            }
        }
        for (const auto& [first, second] : evaluation.assumptions()) {
            const SymbolicField::Element apart = field_.sum(first, field_.negative(second));
            if (field_.is_zero(apart)) throw Error(ErrorCode::division_by_zero, "an assumption never holds");
            field_.require_nonzero(apart);
        }
        expand_sides(reading);
        note_divisors_and_symbols();
    }

    std::string problem() {
        for (const NamedPolynomial& condition : certificate_.conditions) {
            const std::size_t new_names =
                limits_.variables - std::min(limits_.variables, field_.names().size() - symbols_);
            conditions_.push_back(named_polynomial(condition, field_, symbols_, new_names).primitive());
            if (conditions_.back().is_zero()) return "a condition is 0";
            const PlainPolynomial written = conditions_.back();
            if (replaces_) conditions_.push_back(field_.numerator(value_of(condition)).primitive());
            if (!follows_from(written, nonzero_) && !follows_from(conditions_.back(), nonzero_))
                added_.push_back(text_of(written, field_.names()) + " != 0");
        }
        for (const PlainPolynomial& factor : nonzero_) {
            if (!is_covered(factor)) {
                return "the conditions do not say that " + text_of(factor, field_.names()) +
                       " does not vanish";
            }
        }
        // The claim is restricted to points at which the conditions do not vanish.
        nonzero_.insert(nonzero_.end(), conditions_.begin(), conditions_.end());
        BranchState state(equations_, nonzero_, difference_, field_.budget());
        std::string problem = problem_in(certificate_.root, state, "");
        if (problem.empty() && !agrees_somewhere_) problem = "no branch is left in which the sides agree";
        return problem;
    }

    const std::vector<std::string>& added_conditions() const { return added_; }

private:
    /// The difference of the sides, with polynomials substituted for symbols according to the first steps.
    /// Whether the steps follow from the hypotheses is checked later; if they do not, the difference is not
    /// used.
    void expand_sides(const Reading& reading) {
        const std::vector<Step>& steps = certificate_.root.steps;
        std::size_t count = 0;
        while (count < steps.size() && gives_polynomial(steps[count])) ++count;
        replaces_ = count > 0;
        // The replacement of a symbol may contain symbols of later steps.
        while (count-- > 0) replace(steps[count]);
        Evaluation<SymbolicField> evaluation(reading, certificate_.which, field_);
        const SymbolicField::Element left = evaluation.left();
        difference_ = field_.numerator(field_.sum(left, field_.negative(evaluation.right())));
    }

    /// Notes the divisors and symbols of the case, before conditions add others.
    void note_divisors_and_symbols() {
        nonzero_ = field_.divisors();
        symbols_ = field_.names().size();
    }

    bool gives_polynomial(const Step& step) {
        if (step.degree != 1 || !field_.number_of(step.symbol)) return false;
        std::size_t terms = 0;
        for (const NamedTerm& term : step.relation) {
            for (const auto& [name, exponent] : term.powers) {
                if (!field_.number_of(name)) return false;
                if (name != step.symbol || exponent == 0) continue;
                if (term.powers.size() > 1 || exponent > 1) return false;
                ++terms;
            }
        }
        const PlainPolynomial relation = named_polynomial(step.relation, field_, field_.names().size(), 0);
        return terms == 1 && std::ranges::any_of(equations_, [&](const PlainPolynomial& equation) {
                   return equation.primitive() == relation.primitive();
               });
    }

    void replace(const Step& step) {
        NamedPolynomial rest;
        Rational leading;
        for (const NamedTerm& term : step.relation) {
            const bool has_symbol = term.powers.size() == 1 && term.powers.front().first == step.symbol &&
                                    term.powers.front().second == 1;
            if (has_symbol) {
                leading = term.coefficient;
            } else {
                rest.push_back(term);
            }
        }
        if (leading.is_zero()) throw Error(ErrorCode::syntax, "a relation has a term that is 0");
        field_.replace(step.symbol, field_.product(field_.number(Rational(-1) / leading), value_of(rest)));
    }

    /// A polynomial after the replacement of symbols.
    SymbolicField::Element value_of(const NamedPolynomial& polynomial) {
        SymbolicField::Element sum = field_.number(Rational(0));
        for (const NamedTerm& term : polynomial) {
            SymbolicField::Element product = field_.number(term.coefficient);
            for (const auto& [name, exponent] : term.powers)
                product = field_.product(product, field_.power(field_.symbol(name), exponent));
            sum = field_.sum(sum, product);
        }
        return sum;
    }

    bool is_covered(const PlainPolynomial& factor) { return follows_from(factor, conditions_); }

    /// Whether a polynomial divides a product of others.
    bool follows_from(PlainPolynomial factor, const std::vector<PlainPolynomial>& others) {
        for (const PlainPolynomial& other : others) {
            if (factor.is_number() || exact_quotient(other, factor, field_.budget())) return true;
            if (other.is_number()) continue;
            while (auto exact = exact_quotient(factor, other, field_.budget())) factor = std::move(*exact);
        }
        return factor.is_number();
    }

    std::string problem_in(const Branch& branch, BranchState& state, const std::string& place) {
        const auto wrong = [&](const std::string& what) {
            return place.empty() ? what : "branch " + place.substr(1) + ": " + what;
        };
        field_.budget().spend(1);
        if (std::ranges::count(place, '.') > static_cast<std::ptrdiff_t>(limits_.nesting)) {
            return "there are branches within branches beyond the limit nesting = " +
                   std::to_string(limits_.nesting);
        }
        for (std::size_t k = 0; k < branch.steps.size(); ++k) {
            const std::string problem = problem_of_step(branch.steps[k], state);
            if (!problem.empty()) return wrong("step " + std::to_string(k + 1) + ": " + problem);
        }
        if (branch.end != Branch::End::split && !branch.branches.empty()) return wrong("an end has branches");
        switch (branch.end) {
            case Branch::End::agree:
                if (!state.is_impossible()) agrees_somewhere_ = true;
                return state.agrees() ? "" : wrong("the two sides do not reduce to the same");
            case Branch::End::impossible:
                return state.is_impossible() ? "" : wrong("nothing shows that the branch is impossible");
            case Branch::End::split:
                return branch.branches.size() == 2 ? problem_of_split(branch, state, place)
                                                   : wrong("a split needs two branches");
            case Branch::End::open:
                return wrong("a branch may be left open only where the pivot of a split is 0");
        }
        return wrong("the branch has no end");
    }

    std::string problem_of_split(const Branch& branch, BranchState& state, const std::string& place) {
        const PlainPolynomial pivot = named_polynomial(branch.pivot, field_, symbols_, 0);
        if (branch.branches[1].end == Branch::End::open) {
            // No claim is made where the pivot is 0.
            if (std::ranges::find(conditions_, pivot.primitive()) == conditions_.end() || pivot.is_zero()) {
                return "the pivot " + text_of(pivot, field_.names()) + " of an open branch is no condition";
            }
            if (!branch.branches[1].steps.empty() || !branch.branches[1].branches.empty()) {
                return "an open branch goes on";
            }
        } else {
            BranchState other = state;
            field_.budget().spend(other.size());
            other.require_zero(pivot);
            std::string problem = problem_in(branch.branches[1], other, place + ".2");
            if (!problem.empty()) return problem;
        }
        state.require_nonzero(pivot);
        return problem_in(branch.branches[0], state, place + ".1");
    }

    std::string problem_of_step(const Step& step, BranchState& state) {
        const auto symbol = field_.number_of(step.symbol);
        if (!symbol) return "there is no symbol " + quoted(step.symbol) + " in this case";
        return state.take_step(*symbol, step.degree, named_polynomial(step.relation, field_, symbols_, 0));
    }

    const Certificate& certificate_;
    const Limits& limits_;
    SymbolicField field_;
    std::size_t symbols_ = 0;  ///< the symbols of the case; conditions may have more
    PlainPolynomial difference_;
    std::vector<PlainPolynomial> equations_;
    std::vector<PlainPolynomial> nonzero_;
    std::vector<PlainPolynomial> conditions_;
    bool agrees_somewhere_ = false;
    bool replaces_ = false;           ///< whether symbols are replaced according to the first steps
    std::vector<std::string> added_;  ///< conditions that the text does not state
};

/// The problem with the name of the block in a certificate, which the first line of the block may state; ""
/// if there is none.
std::string problem_of_head(const Certificate& certificate) {
    std::string_view rest = certificate.text;
    while (!rest.empty()) {
        std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(rest.size(), line.size() + 1));
        const auto skip_blanks = [&line] {
            line.remove_prefix(std::min(line.size(), line.find_first_not_of(" \t\r")));
        };
        skip_blanks();
        constexpr std::string_view head = "theorem";
        if (line.empty() || line.starts_with('#') || line.starts_with("strict")) continue;
        if (!line.starts_with(head)) return "";
        line.remove_prefix(head.size());
        skip_blanks();
        const std::string_view id = line.substr(0, line.find_first_of(" \t\r\"#"));
        if (id != certificate.id) return "the text is of the theorem " + quoted(id);
        line.remove_prefix(id.size());
        skip_blanks();
        std::string_view title;
        if (line.starts_with('"')) title = line.substr(1, line.find('"', 1) - 1);
        return title == certificate.title ? "" : "the text has the title " + quoted(title);
    }
    return "";
}

std::pair<std::size_t, std::vector<std::pair<std::string, long long>>> key_of(const Case& which) {
    return {which.line, which.parameters};
}

}  // namespace

struct CertificateChecker::Text {
    Text(std::string of, const Limits& limits) : text(std::move(of)), reading(text, limits) {
        for (Case& which : reading.cases()) {
            keys.insert(key_of(which));
            if (reading.claims()[which.line].kind == Statement::Kind::claim)
                claimed.push_back(std::move(which));
        }
    }

    std::string text;
    Reading reading;
    std::vector<Case> claimed;
    std::set<std::pair<std::size_t, std::vector<std::pair<std::string, long long>>>> keys;
};

CertificateChecker::CertificateChecker(const Limits& limits) : limits_(limits) {}
CertificateChecker::~CertificateChecker() = default;

CertificateChecker::Text& CertificateChecker::read(const std::string& text) {
    if (!text_ || text_->text != text) text_ = std::make_unique<Text>(text, limits_);
    return *text_;
}

const std::vector<Case>& CertificateChecker::claimed_cases(const std::string& text) {
    return read(text).claimed;
}

std::string CertificateChecker::problem_of(const Certificate& certificate) {
    try {
        const Text& text = read(certificate.text);
        std::string problem = problem_of_head(certificate);
        if (!problem.empty()) return problem;
        if (!text.keys.contains(key_of(certificate.which))) return "the text has no such case";
        CaseCheck check(text.reading, certificate, limits_);
        problem = check.problem();
        added_conditions_ = check.added_conditions();
        return problem;
    } catch (const Error& error) {
        if (error.code() == ErrorCode::limit_exceeded) throw;
        return error.message().empty() ? "an error without a message" : error.message();
    }
}

std::string problem_of(const Certificate& certificate, const Limits& limits) {
    try {
        return CertificateChecker(limits).problem_of(certificate);
    } catch (const Error& error) {
        return error.message();
    }
}

}  // namespace blossom::proofs::second

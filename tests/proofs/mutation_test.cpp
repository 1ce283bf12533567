#include <blossom/core/algebra/polynomial_text.hpp>
#include <blossom/proofs/formatter.hpp>
#include "decided.hpp"

#include <functional>
#include <iterator>

#include "plain_evaluation.hpp"

// True identities of the literature, each changed in one place: a sign, a coefficient, an index or a bound.
// The prover must refute the results that are false by plain evaluation at random points.

using proofs::Block;
using proofs::Expression;
using proofs::ExpressionKind;
using proofs::Statement;
using proofs::StatementKind;

namespace {

void visit(Expression& e, const std::function<void(Expression&)>& action) {
    action(e);
    for (Expression& child : e.children) visit(child, action);
    for (auto& group : e.groups) {
        for (Expression& child : group) visit(child, action);
    }
}

/// Changes one place of the claim, or does nothing if there is none.
bool spoil(Statement& claim, Random& random) {
    std::vector<Expression*> places;
    for (Expression& side : claim.sides) {
        visit(side, [&](Expression& e) {
            const bool changes = e.kind == ExpressionKind::sum || e.kind == ExpressionKind::number ||
                                 (e.kind == ExpressionKind::name && e.children.size() == 1);
            if (changes) places.push_back(&e);
        });
    }
    if (places.empty()) return false;
    Expression& place = *places[random.below(places.size())];
    if (place.kind == ExpressionKind::sum) {
        char& sign = place.name[random.below(place.name.size())];
        sign = sign == '+' ? '-' : '+';
    } else if (place.kind == ExpressionKind::number) {
        place.name = random.one_in(2) ? "7" : "1" + place.name;
    } else {
        // An index or, in a run, a bound.
        Expression index = place.children[0];
        place.children[0] = {
            ExpressionKind::sum, 0, "+", {std::move(index), {ExpressionKind::number, 0, "1", {}, {}}}, {}};
    }
    return true;
}

std::vector<Rational> random_symbols(const proofs::GroundBlock& block, Random& random) {
    std::vector<Rational> values;
    for (std::size_t i = 0; i < block.symbols.size(); ++i)
        values.emplace_back(Integer(random.between(-40, 40)), Integer(7));
    return values;
}

std::size_t total_degree(const proofs::GroundBlock& block) {
    std::size_t greatest = 0;
    for (const auto& map : block.maps) {
        std::size_t sum = 0;
        for (const auto& direction : map.directions) sum += direction.degree;
        greatest = std::max(greatest, sum);
    }
    return greatest;
}

/// The block with its own text, which both roads read.
Block written_out(const Block& block) {
    proofs::Document document;
    if (block.strict) document.strict = 0;
    document.blocks.push_back(block);
    proofs::Document again = proofs::parse(proofs::formatted(document));
    REQUIRE(again.errors.empty());
    REQUIRE(again.blocks.size() == 1);
    return std::move(again.blocks[0]);
}

/// Whether some case of moderate size is false at a random point; nullopt if that cannot be evaluated.
std::optional<bool> is_false(const Block& block, Random& random) {
    try {
        const Limits limits;
        for (const auto& choice : proofs::parameter_choices(block, limits)) {
            const proofs::GroundBlock grounded = proofs::ground(block, choice, limits);
            if (total_degree(grounded) > 6) continue;
            PlainEvaluation evaluate(grounded, random_symbols(grounded, random));
            for (const auto& relation : grounded.claims) {
                if (relation.error) return std::nullopt;
                if (evaluate(relation.left) != evaluate(relation.right)) return true;
            }
        }
        return false;
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// Whether the sides have the values that the counterexample gives, at its point, by plain evaluation.
bool is_confirmed(const Block& block, const proofs::Counterexample& witness) {
    const Limits limits;
    for (const auto& choice : proofs::parameter_choices(block, limits)) {
        if (!std::equal(choice.begin(), choice.end(), witness.parameters.begin())) continue;
        const proofs::GroundBlock grounded = proofs::ground(block, choice, limits);
        std::vector<Rational> values(grounded.symbols.size());
        const auto set = [&](const std::string& name, const Rational& value) {
            for (std::size_t i = 0; i < values.size(); ++i) {
                if (grounded.symbols[i].name == name) values[i] = value;
            }
        };
        for (const auto& [name, value] : witness.variables) set(name, value);
        for (const auto& map : witness.maps) {
            const auto exponents = proofs::monomials(map.directions);
            std::vector<std::string> names = {"t"};
            if (exponents[0].size() > 1) names = numbered_names("x", exponents[0].size());
            if (map.directions.size() == 2) names = {"u", "v"};
            const SparsePolynomial polynomial = parse_polynomial(map.text, names).polynomial;
            const auto& coefficients =
                std::ranges::find(grounded.maps, map.name, &proofs::GroundMap::name)->coefficients;
            for (std::size_t i = 0; i < exponents.size(); ++i) {
                const proofs::Node& node = grounded.nodes[coefficients[i]];
                if (node.kind != proofs::NodeKind::symbol) continue;
                for (std::size_t term = 0; term < polynomial.size(); ++term) {
                    bool same = true;
                    for (std::size_t j = 0; j < names.size(); ++j)
                        same = same && polynomial.exponent(term, j) == exponents[i][j];
                    if (same) values[node.index] = polynomial.coefficient(term);
                }
            }
        }
        PlainEvaluation evaluate(grounded, values);
        for (const auto& relation : grounded.claims) {
            if (relation.error) continue;
            if (to_string(evaluate(relation.left)) == witness.left &&
                to_string(evaluate(relation.right)) == witness.right && witness.left != witness.right)
                return true;
        }
    }
    return false;
}

std::vector<Block> claims_without_hypotheses() {
    std::vector<Block> result;
    for (const char* name : {"blog", "derose", "fj", "goldman", "hart"}) {
        std::ifstream file(BLOSSOM_SOURCE "/proofs/statements/" + std::string(name) + ".blossom");
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        for (const Block& block : proofs::parse(text).blocks) {
            Block one = block;
            std::erase_if(one.statements, [](const Statement& s) {
                return s.kind == StatementKind::claim || s.kind == StatementKind::refute;
            });
            const bool given = std::ranges::any_of(
                one.statements, [](const Statement& s) { return s.kind == StatementKind::given; });
            if (given) continue;
            for (const Statement& statement : block.statements) {
                if (statement.kind != StatementKind::claim) continue;
                Block with_claim = one;
                with_claim.statements.push_back(statement);
                result.push_back(written_out(with_claim));
            }
        }
    }
    return result;
}

}  // namespace

TEST_CASE("plain evaluation finds the identities of the literature true") {
    Random random(20);
    std::size_t evaluated = 0;
    for (const Block& block : claims_without_hypotheses()) {
        const auto wrong = is_false(block, random);
        if (!wrong) continue;
        INFO(block.id);
        CHECK_FALSE(*wrong);
        ++evaluated;
    }
    CHECK(evaluated > 300);
}

TEST_CASE("200 identities spoiled in one place are refuted, and evaluation confirms the counterexample") {
    Random random(5);
    const std::vector<Block> claims = claims_without_hypotheses();
    std::size_t refuted = 0;
    for (std::size_t attempt = 0; refuted < 200 && attempt < 2000; ++attempt) {
        Block block = claims[random.below(claims.size())];
        if (!spoil(block.statements.back(), random)) continue;
        block = written_out(block);
        if (is_false(block, random) != true) continue;
        INFO(block.id << ": " << proofs::to_text(block.statements.back()));
        const auto decisions = proofs::decide(block);
        REQUIRE(decisions.size() == 1);
        REQUIRE(decisions[0].verdict() == proofs::Verdict::refuted);
        CHECK(is_confirmed(block, *decisions[0].counterexample()));
        ++refuted;
    }
    CHECK(refuted == 200);
}

#include <blossom/proofs/coq.hpp>
#include <blossom/rational/combinatorics.hpp>

#include <algorithm>
#include <set>

namespace blossom::proofs {

namespace {

/// Thrown when a text exceeds its limit.
struct TooLong {};

class Writer {
public:
    Writer(const GroundBlock& block, std::size_t longest) : block_(block), longest_(longest) {}

    std::string text(NodeId id) {
        const Node& node = block_.nodes[id];
        switch (node.kind) {
            case NodeKind::constant:
                return number(node.value);
            case NodeKind::symbol:
                symbols_.insert(node.index);
                return symbol(node.index);
            case NodeKind::sum:
                return joined(node, " + ");
            case NodeKind::product:
                return joined(node, " * ");
            case NodeKind::quotient:
                divisors_.insert(text(node.operands[1]));
                return joined(node, " / ");
            case NodeKind::power:
                return "(" + text(node.operands[0]) + ")^" + std::to_string(node.index);
            case NodeKind::application:
                return checked(application(block_.applications[node.index]));
            case NodeKind::derivative:
                throw TooLong{};
        }
        return "";
    }

    std::string quantified() const {
        std::string names;
        for (const std::size_t number : symbols_) names += " " + symbol(number);
        return names.empty() ? "" : "forall" + names + " : Q, ";
    }
    const std::set<std::string>& divisors() const { return divisors_; }

private:
    std::string checked(std::string text) const {
        if (text.size() > longest_) throw TooLong{};
        return text;
    }

    static std::string number(const Rational& value) {
        if (value.is_integer() && value.sign() >= 0) return to_string(value);
        return "(" + to_string(value.numerator()) + " # " + to_string(value.denominator()) + ")";
    }

    std::string symbol(std::size_t number) const {
        std::string name = "x_" + block_.symbols[number].name;
        std::ranges::replace_if(
            name, [](char c) { return (c < 'a' || c > 'z') && (c < 'A' || c > 'Z') && (c < '0' || c > '9'); },
            '_');
        return name;
    }

    std::string joined(const Node& node, const std::string& sign) {
        std::string result;
        for (const NodeId operand : node.operands) result += (result.empty() ? "(" : sign) + text(operand);
        return checked(result + ")");
    }

    std::string application(const Application& application) {
        const GroundMap& map = block_.maps[application.map];
        if (map.directions.size() != 1 || map.directions[0].dimension != 1) throw TooLong{};
        const std::size_t n = map.directions[0].degree;
        if (!map.barycentric.empty()) throw TooLong{};
        if (application.form == Application::Form::value)
            return value_of(map, n, application.arguments[0][0]);
        const std::string blossom = blossom_of(map, application.arguments[0]);
        return application.scale == Rational(1) ? blossom
                                                : "(" + number(application.scale) + " * " + blossom + ")";
    }

    std::string value_of(const GroundMap& map, std::size_t n, const NodeArgument& argument) {
        std::string result;
        const std::string u = text(argument.coordinates[0]);
        const std::string mass = text(argument.mass);
        for (std::size_t k = 0; k <= n; ++k) {
            result += result.empty() ? "(" : " + ";
            result.append(text(map.coefficients[k])).append(" * (").append(u);
            result += ")^" + std::to_string(k);
            if (mass != "1") result += " * (" + mass + ")^" + std::to_string(n - k);
        }
        return checked(result + ")");
    }

    /// sum_k c_k / C(n, k) sum over k-subsets S of prod_{i in S} u_i prod_{i not in S} mass_i
    std::string blossom_of(const GroundMap& map, const std::vector<NodeArgument>& arguments) {
        const std::size_t n = arguments.size();
        if (n > 10) throw TooLong{};
        std::vector<std::string> sums(n + 1);
        for (std::size_t subset = 0; subset < std::size_t{1} << n; ++subset) {
            std::string product;
            std::size_t size = 0;
            bool vanishes = false;
            for (std::size_t i = 0; i < n; ++i) {
                const bool chosen = (subset >> i) % 2 == 1;
                size += chosen ? 1 : 0;
                const std::string factor = text(chosen ? arguments[i].coordinates[0] : arguments[i].mass);
                vanishes = vanishes || factor == "0";
                if (factor != "1") product += (product.empty() ? "" : " * ") + factor;
            }
            if (vanishes) continue;
            sums[size] += (sums[size].empty() ? "" : " + ") + (product.empty() ? "1" : product);
            checked(sums[size]);
        }
        std::string result;
        for (std::size_t k = 0; k <= n; ++k) {
            if (sums[k].empty()) continue;
            result += (result.empty() ? "(" : " + ") + number(Rational(1, binomial(n, k))) + " * " +
                      text(map.coefficients[k]) + " * (" + sums[k] + ")";
        }
        return result.empty() ? "0" : checked(result + ")");
    }

    const GroundBlock& block_;
    std::size_t longest_;
    std::set<std::size_t> symbols_;
    std::set<std::string> divisors_;
};

}  // namespace

std::string coq_preamble() { return "From Coq Require Import QArith Qfield.\nLocal Open Scope Q_scope.\n"; }

std::optional<std::string> coq_lemma(const ProvedCase& proved, const std::string& name, std::size_t longest) {
    if (!proved.block.hypotheses.empty()) return std::nullopt;
    try {
        Writer writer(proved.block, longest);
        const std::string left = writer.text(proved.relation.left);
        const std::string right = writer.text(proved.relation.right);
        std::string lemma = "\nLemma " + name + " : " + writer.quantified();
        for (const std::string& divisor : writer.divisors()) lemma += "\n  ~ " + divisor + " == 0 ->";
        lemma +=
            "\n  " + left + "\n  == " + right + ".\nProof. intros; field; repeat split; assumption. Qed.\n";
        if (lemma.size() > longest) return std::nullopt;
        return lemma;
    } catch (const TooLong&) {
        return std::nullopt;
    }
}

}  // namespace blossom::proofs

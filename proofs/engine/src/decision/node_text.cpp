#include "node_text.hpp"

#include <blossom/rational/lists.hpp>
#include <blossom/rational/number_text.hpp>

#include <algorithm>

namespace blossom::proofs {

namespace {

constexpr std::size_t longest = 200;

enum class Tightness { sum, product, atom };

class NodeText {
public:
    explicit NodeText(const GroundBlock& block) : block_(block) {}

    std::string print(NodeId id, Tightness least) {
        const Node& node = block_.nodes[id];
        std::string text = unbracketed(node);
        if (text.size() > longest) text = text.substr(0, longest) + "...";
        return tightness_of(node) < least ? "(" + text + ")" : text;
    }

private:
    static Tightness tightness_of(const Node& node) {
        if (node.kind == NodeKind::sum) return Tightness::sum;
        if (node.kind == NodeKind::product || node.kind == NodeKind::quotient || node.kind == NodeKind::power)
            return Tightness::product;
        const bool plain =
            node.kind != NodeKind::constant || (node.value.is_integer() && node.value.sign() >= 0);
        return plain ? Tightness::atom : Tightness::product;
    }

    std::string unbracketed(const Node& node) {
        switch (node.kind) {
            case NodeKind::constant:
                return to_string(node.value);
            case NodeKind::symbol:
                return block_.symbols[node.index].name;
            case NodeKind::sum:
                return sum(node);
            case NodeKind::product:
                return product(node);
            case NodeKind::quotient:
                return print(node.operands[0], Tightness::product) + "/" +
                       print(node.operands[1], Tightness::atom);
            case NodeKind::power:
                return print(node.operands[0], Tightness::atom) + "^" + std::to_string(node.index);
            case NodeKind::application:
                return application(block_.applications[node.index]);
            case NodeKind::derivative:
                return "D(" + print(node.operands[0], Tightness::sum) + ", " +
                       block_.symbols[node.index].name +
                       (node.order == 1 ? "" : ", " + std::to_string(node.order)) + ")";
        }
        return "";
    }

    std::string sum(const Node& node) {
        std::string text;
        for (const NodeId operand : node.operands) {
            const std::string term = print(operand, Tightness::product);
            if (text.empty()) {
                text = term;
            } else {
                text += term.front() == '-' ? " - " + term.substr(1) : " + " + term;
            }
            if (text.size() > longest) break;
        }
        return text;
    }

    /// Puts a number, which grounding puts last, in front.
    std::string product(const Node& node) {
        std::string sign;
        std::string text;
        for (const NodeId operand : node.operands) {
            const Node& factor = block_.nodes[operand];
            if (factor.kind == NodeKind::constant) {
                sign = factor.value == Rational(-1) ? "-" : to_string(factor.value) + "*";
                continue;
            }
            text += (text.empty() ? "" : "*") + print(operand, Tightness::atom);
            if (text.size() > longest) break;
        }
        return sign + text;
    }

    std::string argument(const NodeArgument& argument) {
        std::string coordinates = joined(
            argument.coordinates, [&](const NodeId coordinate) { return print(coordinate, Tightness::sum); });
        if (argument.coordinates.size() > 1) coordinates = "(" + coordinates + ")";
        const Node& mass = block_.nodes[argument.mass];
        if (mass.kind == NodeKind::constant && mass.value == Rational(1)) return coordinates;
        if (mass.kind == NodeKind::constant && mass.value.is_zero() && coordinates == "1") return "delta";
        return "<" + coordinates + ", " + print(argument.mass, Tightness::sum) + ">";
    }

    std::string application(const Application& application) {
        const bool value = application.form == Application::Form::value;
        std::string text;
        for (const auto& list : application.arguments) {
            const std::string direction =
                joined(list, [&](const NodeArgument& one) { return argument(one); });
            if (&list != &application.arguments.front()) text += value ? ", " : "; ";
            text += direction;
        }
        if (application.form == Application::Form::derivative) return derivative(application);
        return block_.maps[application.map].name + (value ? "(" + text + ")" : "[" + text + "]");
    }

    std::string derivative(const Application& application) {
        std::string name = block_.maps[application.map].name;
        const auto& arguments = application.arguments.front();
        const bool by_directions = application.places.front().coordinates.size() > 1;
        for (const std::size_t order : application.orders) {
            if (!by_directions) name += ", " + std::to_string(order);
            const std::size_t first = arguments.size() - std::min(order, arguments.size());
            for (std::size_t k = first; by_directions && k < arguments.size(); ++k)
                name += ", " + argument(arguments[k]);
        }
        const std::string places =
            joined(application.places, [&](const NodeArgument& place) { return argument(place); });
        return "D(" + name + ")(" + places + ")";
    }

    const GroundBlock& block_;
};

}  // namespace

std::string node_text(const GroundBlock& block, NodeId node) {
    return NodeText(block).print(node, Tightness::sum);
}

}  // namespace blossom::proofs

#include "second_counting.hpp"

#include <blossom/rational/error.hpp>

#include <algorithm>
#include <numeric>
#include <utility>

namespace blossom::proofs::second {

IntegerSet Counting::ground_set(NodeId id, Scope& scope) {
    if (reading_.node(id).kind == Kind::set) return set(id, scope);
    const std::size_t size = count(id, scope, reading_.limits().degree, "the size of a set");
    IntegerSet members(size);
    std::iota(members.begin(), members.end(), 1LL);
    return members;
}

IntegerSet Counting::set(NodeId id, Scope& scope) {
    const Node& node = reading_.node(id);
    if (node.form == Form::name && node.meaning == Meaning::local && node.kind == Kind::set) {
        return *scope[node.target].set;
    }
    IntegerSet members;
    if (node.form == Form::interval) {
        const long long low = integer(node.children[0], scope);
        const long long high = integer(node.children[1], scope);
        if (high >= low) work_.step(static_cast<std::size_t>(high - low));
        for (long long member = low; member <= high; ++member) members.push_back(member);
        return members;
    }
    if (node.form == Form::without) {
        const IntegerSet left_out = set(node.children[1], scope);
        for (const long long member : ground_set(node.children[0], scope)) {
            if (!std::ranges::binary_search(left_out, member)) members.push_back(member);
        }
        return members;
    }
    throw Error(ErrorCode::wrong_kind, "a set of integers is expected here", {}, node.offset);
}

void Counting::each(NodeId domain, std::uint32_t slot, Scope& scope, const std::function<void()>& body) {
    const Node& node = reading_.node(domain);
    if (node.form == Form::interval) {
        const long long low = integer(node.children[0], scope);
        const long long high = integer(node.children[1], scope);
        for (long long member = low; member <= high; ++member) {
            work_.step();
            scope[slot] = {member, nullptr, nullptr};
            body();
        }
    } else if (node.form == Form::subsets) {
        each_subset(node, slot, scope, body);
    } else if (node.form == Form::partitions) {
        each_partition(node, slot, scope, body);
    } else if (node.form == Form::permutations) {
        each_permutation(node, slot, scope, body);
    } else if (node.kind == Kind::set_of_sets) {
        for (const IntegerSet& member : *scope[node.target].sets) {
            scope[slot] = {0, &member, nullptr};
            body();
        }
    } else {
        for (const long long member : set(domain, scope)) {
            scope[slot] = {member, nullptr, nullptr};
            body();
        }
    }
}

// In lexicographic order: the last member that can increase does so, and the members behind it take the next
// values.
void Counting::each_subset(const Node& subsets, std::uint32_t slot, Scope& scope,
                           const std::function<void()>& body) {
    const IntegerSet ground = ground_set(subsets.children[0], scope);
    const long long wanted = integer(subsets.children[1], scope);
    if (wanted < 0 || wanted > static_cast<long long>(ground.size())) return;
    const auto size = static_cast<std::size_t>(wanted);
    std::vector<std::size_t> places(size);
    std::iota(places.begin(), places.end(), std::size_t{0});
    IntegerSet subset(size);
    while (true) {
        work_.step(size + 1);
        for (std::size_t i = 0; i < size; ++i) subset[i] = ground[places[i]];
        scope[slot] = {0, &subset, nullptr};
        body();
        std::size_t moving = size;
        while (moving > 0 && places[moving - 1] == ground.size() - size + moving - 1) --moving;
        if (moving == 0) return;
        ++places[moving - 1];
        for (std::size_t i = moving; i < size; ++i) places[i] = places[i - 1] + 1;
    }
}

// Partitions as restricted growth strings: each member goes to an existing block or to a new one.
void Counting::each_partition(const Node& partitions, std::uint32_t slot, Scope& scope,
                              const std::function<void()>& body) {
    const IntegerSet ground = ground_set(partitions.children[0], scope);
    std::vector<std::size_t> block_of(ground.size(), 0);
    while (true) {
        work_.step(ground.size() + 1);
        std::vector<IntegerSet> blocks;
        for (std::size_t i = 0; i < ground.size(); ++i) {
            if (block_of[i] == blocks.size()) blocks.emplace_back();
            blocks[block_of[i]].push_back(ground[i]);
        }
        scope[slot] = {0, nullptr, &blocks};
        body();
        std::size_t moving = ground.size();
        while (moving > 0) {
            const std::size_t place = moving - 1;
            const std::size_t most =
                place == 0
                    ? 0
                    : *std::max_element(block_of.begin(), block_of.begin() + static_cast<long>(place)) + 1;
            if (block_of[place] < most) break;
            --moving;
        }
        if (moving == 0) return;
        ++block_of[moving - 1];
        for (std::size_t i = moving; i < block_of.size(); ++i) block_of[i] = 0;
    }
}

void Counting::each_permutation(const Node& permutations, std::uint32_t slot, Scope& scope,
                                const std::function<void()>& body) {
    IntegerSet images = ground_set(permutations.children[0], scope);
    do {
        work_.step(images.size() + 1);
        scope[slot] = {0, &images, nullptr};
        body();
    } while (std::ranges::next_permutation(images).found);
}

IntegerSet Counting::family_members(const Node& family, Scope& scope) {
    IntegerSet members = set(family.children.front(), scope);
    for (std::size_t i = 1; i + 1 < family.children.size(); ++i) {
        const Node& exclusion = reading_.node(family.children[i]);
        if (exclusion.form == Form::excluded) {
            std::erase(members, integer(exclusion.children[0], scope));
            continue;
        }
        const IntegerSet left_out = set(exclusion.children[0], scope);
        std::erase_if(members,
                      [&](long long member) { return std::ranges::binary_search(left_out, member); });
    }
    return members;
}

void Counting::each_range(const std::vector<Range>& ranges, Scope& scope, const std::function<void()>& body) {
    each_choice_of(ranges, 0, scope, body);
}

void Counting::each_choice_of(const std::vector<Range>& ranges, std::size_t place, Scope& scope,
                              const std::function<void()>& body) {
    if (place == ranges.size()) return body();
    const long long low = integer(ranges[place].low, scope);
    const long long high = integer(ranges[place].high, scope);
    for (long long member = low; member <= high; ++member) {
        work_.step();
        scope[place] = {member, nullptr, nullptr};
        each_choice_of(ranges, place + 1, scope, body);
    }
}

}  // namespace blossom::proofs::second

#include <blossom/rational/made_once.hpp>
#include "rational_test.hpp"

#include <new>
#include <thread>
#include <vector>

TEST_CASE("a value is made once, for all threads") {
    const MadeOnce<std::vector<int>> once;
    std::atomic<int> made = 0;
    std::vector<const std::vector<int>*> seen(8);
    std::vector<std::thread> threads;
    for (auto& place : seen) {
        threads.emplace_back([&] {
            place = &once.value([&] {
                ++made;
                return std::vector<int>{1, 2, 3};
            });
        });
    }
    for (std::thread& thread : threads) thread.join();
    CHECK(made == 1);
    CHECK(*once.if_made() == std::vector<int>{1, 2, 3});
    for (const auto* place : seen) CHECK(place == once.if_made());
}

TEST_CASE("if making a value fails, the next caller makes it") {
    const MadeOnce<int> once;
    CHECK_THROWS_AS(once.value([]() -> int { throw std::bad_alloc(); }), std::bad_alloc);
    CHECK(once.if_made() == nullptr);
    CHECK(once.value([] { return 5; }) == 5);
    CHECK(once.value([] { return 6; }) == 5);
}

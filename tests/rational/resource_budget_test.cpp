#include <blossom/rational/integer.hpp>
#include <blossom/rational/resource_budget.hpp>
#include <blossom/rational/taylor_shift.hpp>
#include "rational_test.hpp"

#include <thread>

namespace {

Limits limits_of(std::size_t work, std::size_t memory = 1 << 20, std::size_t timeout = 0) {
    Limits limits;
    limits.work = work;
    limits.memory = memory;
    limits.timeout = timeout;
    return limits;
}

/// The message of the refusal of `action`, or "".
template <class Action>
std::string refusal(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        CHECK(error.code() == ErrorCode::limit_exceeded);
        return error.message();
    } catch (const std::bad_alloc& problem) {
        return resource_error(problem).message();
    }
    return "";
}

Integer power_of_three(std::size_t exponent) { return pow(Integer(3), exponent); }

}  // namespace

TEST_CASE("work beyond a budget is refused with its limit") {
    const Limits limits = limits_of(1'000'000);
    const ResourceBudget budget(limits);
    CHECK(refusal([] { spend_work(999'000); }).empty());
    CHECK(refusal([] { spend_work(2'000); }) == "the work exceeds the limit work = 1000000 word operations");
    CHECK(refusal([] { spend_work(1'000); }).empty());  // what a message needs
    CHECK(refusal([] {
              for (int i = 0; i < 100; ++i) spend_work(1'000);
          }) == "the work exceeds the limit work = 1000000 word operations");
}

TEST_CASE("an amount of work beyond all numbers is refused too") {
    const Limits limits;
    const ResourceBudget budget(limits);
    CHECK_FALSE(refusal([] { spend_work(~std::uint64_t{0}); }).empty());
}

TEST_CASE("without a budget nothing is refused") {
    CHECK(refusal([] {
              for (int i = 0; i < 10; ++i) spend_work(~std::uint64_t{0});
              take_bytes(std::size_t{1} << 62);
              give_back_bytes(std::size_t{1} << 62);
          }).empty());
}

TEST_CASE("a budget ends with its object, and with it what was refused") {
    const Limits limits = limits_of(1'000);
    {
        const ResourceBudget budget(limits);
        CHECK_FALSE(refusal([] { spend_work(10'000); }).empty());
    }
    CHECK(refusal([] { spend_work(100'000'000); }).empty());
}

TEST_CASE("a budget within another ends no later, and counts for it") {
    const Limits outer_limits = limits_of(1'000'000);
    const ResourceBudget outer(outer_limits);
    {
        const Limits limits = limits_of(10'000'000);
        const ResourceBudget inner(limits);
        CHECK(refusal([] { spend_work(600'000); }).empty());
        CHECK_FALSE(refusal([] { spend_work(600'000); }).empty());
    }
    CHECK_FALSE(refusal([] {
                    for (int i = 0; i < 100; ++i) spend_work(1'000);
                }).empty());
}

TEST_CASE("an inner budget that is used up leaves the rest of the outer one") {
    const Limits outer_limits = limits_of(10'000'000);
    const ResourceBudget outer(outer_limits);
    {
        const Limits limits = limits_of(1'000'000);
        const ResourceBudget inner(limits);
        CHECK_FALSE(refusal([] { spend_work(2'000'000); }).empty());
    }
    CHECK(refusal([] { spend_work(5'000'000); }).empty());
    CHECK_FALSE(refusal([] { spend_work(5'000'000); }).empty());
}

TEST_CASE("memory within a budget within another is limited by both, and counts for both") {
    const Limits outer_limits = limits_of(1'000'000'000, 1'000'000);
    const ResourceBudget outer(outer_limits);
    const std::string message = "the memory exceeds the limit memory = ";
    {
        const Limits limits = limits_of(1'000'000'000, 10'000'000);
        const ResourceBudget inner(limits);
        CHECK(refusal([] { take_bytes(2'000'000); }).starts_with(message));
        CHECK(refusal([] { take_bytes(600'000); }).empty());
    }
    CHECK(refusal([] { take_bytes(600'000); }).starts_with(message));
    give_back_bytes(600'000);
    CHECK(refusal([] { take_bytes(600'000); }).empty());
    give_back_bytes(600'000);
}

TEST_CASE("taking memory is work, and what is refused for its work is not taken") {
    const Limits limits = limits_of(10'000, 1'000'000);
    const ResourceBudget budget(limits);
    const std::string message = "the work exceeds the limit work = 10000 word operations";
    CHECK(refusal([] {
              for (int i = 0; i < 10'000; ++i) {
                  take_bytes(32);
                  give_back_bytes(32);
              }
          }) == message);
    CHECK(refusal([] {
              for (int i = 0; i < 10'000; ++i) take_bytes(100);
          }) == message);
}

TEST_CASE("arithmetic beyond 64 bits and kernels count") {
    const auto uses = [](const auto& action) {
        const Limits limits = limits_of(1'000'000);
        const ResourceBudget budget(limits);
        return !refusal(action).empty();
    };
    const Integer large = power_of_three(300'000);
    CHECK_FALSE(uses([] { static_cast<void>(power_of_three(100)); }));
    CHECK(uses([&] { static_cast<void>(large * large); }));
    CHECK(uses([&] { static_cast<void>(Integer(large) *= large); }));
    CHECK(uses([&] { static_cast<void>(Integer(1).add_product(large, large)); }));
    CHECK(uses([&] { static_cast<void>(large * large / (large + 1)); }));
    CHECK(uses([&] { static_cast<void>(gcd(large, large + 2)); }));
    CHECK(uses([&] { static_cast<void>(to_string(large)); }));
    const std::vector<Integer> coefficients(2'000, Integer(12'345));
    CHECK(uses([&] { static_cast<void>(shifted_by_one(coefficients)); }));
}

TEST_CASE("processor time beyond a budget is refused") {
    const Limits limits = limits_of(std::size_t{1} << 60, 1 << 20, 1);
    const ResourceBudget budget(limits);
    const Integer large = power_of_three(50'000);
    CHECK(refusal([&] {
              while (true) static_cast<void>(large * large);
          }) == "the processor time exceeds the limit timeout = 1 seconds");
}

TEST_CASE("memory beyond a budget is refused, and what is given back can be taken again") {
    const Limits limits = limits_of(1'000'000'000, 1'000'000);
    const ResourceBudget budget(limits);
    for (int i = 0; i < 5; ++i) {
        CHECK(refusal([] { take_bytes(900'000); }).empty());
        CHECK(refusal([] { take_bytes(200'000); }) == "the memory exceeds the limit memory = 1000000 bytes");
        CHECK(refusal([] { take_bytes(~std::size_t{0}); }) ==
              "the memory exceeds the limit memory = 1000000 bytes");
        give_back_bytes(900'000);
    }
}

TEST_CASE("budgets belong to their threads") {
    const Limits limits = limits_of(1'000);
    const ResourceBudget budget(limits);
    std::string other = "none";
    std::thread([&] { other = refusal([] { spend_work(1'000'000); }); }).join();
    CHECK(other.empty());
}

TEST_CASE("memory that the system refuses is a limit too") {
    CHECK(resource_error(std::bad_alloc()).code() == ErrorCode::limit_exceeded);
    CHECK(resource_error(std::bad_alloc()).message() == "the memory of this machine does not suffice");
}

TEST_CASE("a thread that shall stop is refused at the next check, whatever is left") {
    static thread_local bool stops = false;
    is_stopped = [] { return stops; };
    const Limits limits = limits_of(1'000'000'000);
    const ResourceBudget budget(limits);
    const auto work = [] {
        for (int i = 0; i < 10; ++i) spend_work(1'000'000);
    };
    CHECK(refusal(work).empty());
    stops = true;
    CHECK(refusal(work) == "the computation was stopped");
    CHECK(refusal([] {
              take_bytes(1'000);
              spend_work(1'000'000);
          }) == "the computation was stopped");
    is_stopped = nullptr;
    CHECK(refusal(work).empty());
}

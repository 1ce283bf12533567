#include <blossom/rational/resource_budget.hpp>

#include <ctime>
#include <optional>
#include <string>

namespace blossom {

namespace {

/// The word operations between two readings of the time, about a tenth of a millisecond.
constexpr std::int64_t words_between_checks = 1 << 18;

constexpr std::int64_t nanoseconds_per_second = 1'000'000'000;
constexpr std::int64_t most_seconds = ThreadResources::unlimited / nanoseconds_per_second / 2;

/// The processor time of this thread, in nanoseconds.
std::int64_t processor_time() {
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return time.tv_sec * nanoseconds_per_second + time.tv_nsec;
}

std::int64_t limited(std::size_t amount) {
    constexpr auto most = static_cast<std::size_t>(ThreadResources::unlimited);
    return static_cast<std::int64_t>(std::min(amount, most));
}

std::int64_t words_left(const ThreadResources& resources) {
    return resources.words_until_check + resources.words_after_check;
}

/// Divides the remaining work into what is allowed until the next check and the rest.
void set_words(ThreadResources& resources, std::int64_t words) {
    resources.words_until_check = std::min(words, words_between_checks);
    resources.words_after_check = words - resources.words_until_check;
}

}  // namespace

constinit thread_local ThreadResources thread_resources;
constinit thread_local StopQuestion is_stopped = nullptr;

// The time is first read at the first check, so that short requests never read it.
ResourceBudget::ResourceBudget(const Limits& limits) : outer_(thread_resources) {
    set_words(start_, std::min(words_left(outer_), limited(limits.work)));
    start_.bytes = std::min(outer_.bytes, limited(limits.memory));
    start_.nanoseconds = outer_.nanoseconds;
    start_.checked_at = outer_.checked_at;
    start_.limits = &limits;
    if (limits.timeout > 0) {
        const std::int64_t seconds = std::min(limited(limits.timeout), most_seconds);
        start_.nanoseconds = std::min(outer_.nanoseconds, seconds * nanoseconds_per_second);
    }
    thread_resources = start_;
}

ResourceBudget::~ResourceBudget() {
    const ThreadResources end = thread_resources;
    thread_resources = outer_;
    if (!outer_.limits) return;
    thread_resources.words_until_check -= words_left(start_) - words_left(end);
    thread_resources.bytes -= start_.bytes - end.bytes;
    thread_resources.nanoseconds -= start_.nanoseconds - end.nanoseconds;
    thread_resources.checked_at = end.checked_at;
}

namespace {

using Resource = ResourcesExceeded::Resource;

constexpr std::int64_t words_of_message = 1 << 14;

/// The error if something is used up. Later checks give the same error, but leave room for a message.
std::optional<ResourcesExceeded> checked() {
    ThreadResources& resources = thread_resources;
    if (!resources.limits) {
        set_words(resources, ThreadResources::unlimited);
        return std::nullopt;
    }
    const std::int64_t left = std::max<std::int64_t>(words_left(resources), 0);
    set_words(resources, left);
    const std::int64_t now = processor_time();
    if (resources.checked_at != 0) resources.nanoseconds -= now - resources.checked_at;
    resources.checked_at = now;
    const bool in_time = resources.nanoseconds > 0;
    const bool stopped = is_stopped && is_stopped();
    if (left > 0 && in_time && !stopped) return std::nullopt;
    resources.words_until_check = words_of_message;
    resources.words_after_check = left - words_of_message;
    if (stopped) return ResourcesExceeded(Resource::stopped, 0);
    if (left == 0) return ResourcesExceeded(Resource::work, resources.limits->work);
    return ResourcesExceeded(Resource::time, resources.limits->timeout);
}

}  // namespace

void check_resources() {
    if (const auto exceeded = checked()) throw exceeded->error();
}

void check_taken(std::int64_t bytes, std::int64_t words) {
    ThreadResources& resources = thread_resources;
    if (resources.bytes < 0) {
        resources.bytes += bytes;
        resources.words_until_check += words;
        throw ResourcesExceeded(Resource::memory, resources.limits ? resources.limits->memory : 0);
    }
    if (const auto exceeded = checked()) {
        resources.bytes += bytes;
        throw ResourcesExceeded(*exceeded);
    }
}

Error ResourcesExceeded::error() const {
    const auto exceeded = [&](std::string_view what, std::string_view name, const char* unit) {
        const Error error = limit_error(what, name, limit_);
        return error.saying(error.message() + unit);
    };
    switch (resource_) {
        case Resource::work:
            return exceeded("the work exceeds", "work", " word operations");
        case Resource::memory:
            return exceeded("the memory exceeds", "memory", " bytes");
        case Resource::stopped:
            return {ErrorCode::limit_exceeded, "the computation was stopped"};
        case Resource::time:
            break;
    }
    return exceeded("the processor time exceeds", "timeout", " seconds");
}

Error resource_error(const std::bad_alloc& problem) {
    const auto* exceeded = dynamic_cast<const ResourcesExceeded*>(&problem);
    return exceeded ? exceeded->error()
                    : Error(ErrorCode::limit_exceeded, "the memory of this machine does not suffice");
}

}  // namespace blossom

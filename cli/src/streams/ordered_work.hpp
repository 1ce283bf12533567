#pragma once

#include <blossom/rational/resource_budget.hpp>

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace blossom::cli {

/// Runs jobs on several threads and passes them to `take` in order, one at a time, as soon as each job and
/// all earlier ones are done, also while the caller waits for the next job; it holds at most 4 jobs per
/// thread. With one thread, the caller runs each job when it is added.
template <class Job>
class OrderedWork {
public:
    /// `take` returns false to end the work.
    OrderedWork(std::size_t threads, std::function<void(Job&)> work, std::function<bool(Job&)> take)
        : work_(std::move(work)), take_(std::move(take)), most_jobs_(4 * threads) {
        try {
            for (std::size_t i = 0; threads > 1 && i < threads; ++i) threads_.emplace_back([this] { run(); });
        } catch (const std::exception&) {  // NOLINT(bugprone-empty-catch)
            // If the system refuses a thread, the threads that have started, or the caller, do the work.
        }
        std::unique_lock lock(mutex_);
        has_room_.wait(lock, [&] { return prepared_ == threads_.size(); });
    }
    OrderedWork(OrderedWork&&) = delete;  // the threads refer to this object
    OrderedWork& operator=(OrderedWork&&) = delete;
    OrderedWork(const OrderedWork&) = delete;
    OrderedWork& operator=(const OrderedWork&) = delete;
    ~OrderedWork() { join(); }

    /// Waits for room and adds a job. False if `take` has ended the work.
    bool add(Job job) {
        if (threads_.empty()) {
            work_(job);
            return take_(job);
        }
        std::unique_lock lock(mutex_);
        // Once full, several jobs at a time: each wait takes a processor from a thread.
        if (jobs_.size() == most_jobs_) has_room_.wait(lock, [&] { return jobs_.size() <= most_jobs_ / 2; });
        jobs_.push_back({std::move(job), false});
        has_work_.notify_one();
        return wanted_;
    }

    /// Waits until every job is taken. Rethrows an exception of `work` or `take`.
    void finish() {
        join();
        if (problem_) std::rethrow_exception(problem_);
    }

private:
    struct Entry {
        Job job;
        bool done;
    };

    void join() {
        {
            const std::scoped_lock lock(mutex_);
            finished_ = true;
            has_work_.notify_all();
        }
        for (std::thread& thread : threads_) {
            if (thread.joinable()) thread.join();
        }
    }

    void run() {
        prepare_thread_for_numbers();
        std::unique_lock lock(mutex_);
        ++prepared_;
        has_room_.notify_one();
        while (true) {
            has_work_.wait(lock, [&] { return finished_ || started_ < jobs_.size(); });
            if (started_ == jobs_.size()) return;
            Entry& entry = jobs_[started_++];  // stays where it is while others come and go at the ends
            lock.unlock();
            std::exception_ptr problem;
            try {
                work_(entry.job);
            } catch (...) {
                problem = std::current_exception();
            }
            lock.lock();
            if (problem) stop(problem);
            entry.done = true;
            take_what_is_next();
        }
    }

    void take_what_is_next() {
        while (!jobs_.empty() && jobs_.front().done) {
            try {
                wanted_ = wanted_ && take_(jobs_.front().job);
            } catch (...) {
                stop(std::current_exception());
            }
            jobs_.pop_front();
            --started_;
            if (jobs_.size() <= most_jobs_ / 2) has_room_.notify_one();
        }
    }

    /// Keeps the exception for the thread that waits for the end.
    void stop(const std::exception_ptr& problem) {
        if (!problem_) problem_ = problem;
        wanted_ = false;
    }

    std::function<void(Job&)> work_;
    std::function<bool(Job&)> take_;
    std::size_t most_jobs_;
    std::mutex mutex_;
    std::condition_variable has_work_;
    std::condition_variable has_room_;
    std::size_t prepared_ = 0;  ///< threads that have begun
    std::deque<Entry> jobs_;    ///< in order, from the first that is not taken
    std::size_t started_ = 0;   ///< jobs that are running or done
    bool finished_ = false;
    bool wanted_ = true;
    std::exception_ptr problem_;
    std::vector<std::thread> threads_;
};

}  // namespace blossom::cli

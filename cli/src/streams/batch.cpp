#include "batch.hpp"

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>

namespace blossom::cli {

namespace {

bool is_blank(const LineReader::Line& line) {
    return !line.too_long && line.text.find_first_not_of(" \t\r") == std::string::npos;
}

Response response_to(const LineReader::Line& line, const Limits& limits) {
    return line.too_long ? protocol::refuse_long_line(limits) : protocol::answer(line.text, limits);
}

/// Writes responses and keeps the outcome of the batch.
class Responses {
public:
    explicit Responses(const Sink& sink) : sink_(sink) {}

    /// False when nobody takes responses any more.
    bool write(Response&& response) {
        outcome_ = std::max(outcome_, response.outcome);
        response.text += '\n';
        try {
            open_ = open_ && sink_(response.text);
        } catch (...) {
            // Kept for the thread that waits for the outcome; this may be another.
            problem_ = std::current_exception();
            open_ = false;
        }
        if (!open_) outcome_ = std::max(outcome_, Outcome::refused);
        return open_;
    }
    bool open() const { return open_; }
    /// Throws what the sink has thrown.
    Outcome outcome() const {
        if (problem_) std::rethrow_exception(problem_);
        return outcome_;
    }

private:
    const Sink& sink_;
    bool open_ = true;
    Outcome outcome_ = Outcome::success;
    std::exception_ptr problem_;
};

/// Lines on their way through several threads.
class OrderedWork {
public:
    OrderedWork(const Sink& sink, const Limits& limits, std::size_t jobs)
        : responses_(sink), limits_(limits), most_lines_(4 * jobs) {
        threads_.reserve(jobs);
        for (std::size_t i = 0; i < jobs; ++i) threads_.emplace_back([this] { work(); });
    }
    OrderedWork(OrderedWork&&) = delete;  // the threads refer to this object
    OrderedWork& operator=(OrderedWork&&) = delete;
    OrderedWork(const OrderedWork&) = delete;
    OrderedWork& operator=(const OrderedWork&) = delete;
    ~OrderedWork() { join(); }

    /// Waits for room, then hands the line to a thread. False when nobody takes responses any more.
    bool add(LineReader::Line line) {
        std::unique_lock lock(mutex_);
        has_room_.wait(lock, [&] { return lines_.size() < most_lines_; });
        lines_.push_back({std::move(line), {}, false});
        has_work_.notify_one();
        return responses_.open();
    }

    /// Waits until every line is answered.
    Outcome finish() {
        join();
        return responses_.outcome();
    }

private:
    struct Entry {
        LineReader::Line line;
        Response served;
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

    void work() {
        std::unique_lock lock(mutex_);
        while (true) {
            has_work_.wait(lock, [&] { return finished_ || started_ < lines_.size(); });
            if (started_ == lines_.size()) return;
            Entry& entry =
                lines_[started_++];  // stays where it is while others are added and removed at the ends
            const LineReader::Line line = std::move(entry.line);
            lock.unlock();
            Response served = response_to(line, limits_);
            lock.lock();
            entry.served = std::move(served);
            entry.done = true;
            write_what_is_next();
        }
    }

    void write_what_is_next() {
        while (!lines_.empty() && lines_.front().done) {
            responses_.write(std::move(lines_.front().served));
            lines_.pop_front();
            --started_;
            has_room_.notify_one();
        }
    }

    std::mutex mutex_;
    std::condition_variable has_work_;
    std::condition_variable has_room_;
    std::deque<Entry> lines_;  ///< in order, from the first whose response is not written
    std::size_t started_ = 0;  ///< how many of them a thread has taken
    bool finished_ = false;
    Responses responses_;
    const Limits& limits_;
    std::size_t most_lines_;
    std::vector<std::thread> threads_;
};

}  // namespace

Outcome serve_batch(const LineReader::Source& source, const Sink& sink, const Limits& limits,
                    std::size_t jobs) {
    LineReader reader(source, limits.line_bytes);
    if (jobs == 1) {
        Responses responses(sink);
        while (const auto line = reader.next()) {
            if (!is_blank(*line) && !responses.write(response_to(*line, limits))) break;
        }
        return responses.outcome();
    }
    OrderedWork work(sink, limits, jobs);
    while (auto line = reader.next()) {
        if (!is_blank(*line) && !work.add(std::move(*line))) break;
    }
    return work.finish();
}

}  // namespace blossom::cli

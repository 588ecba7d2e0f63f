// Copyright (c) 2026 The CGAL Multisided Patches project.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef MULTIPATCH_MPI_MESSAGES_H
#define MULTIPATCH_MPI_MESSAGES_H

#include <boost/mpi/communicator.hpp>
#include <boost/mpi/exception.hpp>
#include <boost/mpi/request.hpp>
#include <boost/mpi/status.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace multipatch {

// What ranks say to each other: texts of these kinds.
enum Mpi_message {
  ready,   // to rank 0, at first: the hash of the options, a space, and the name of the host
  task,    // from rank 0: the name of an input
  outcome, // to rank 0: what became of it, in JSON
  alive,   // both ways, from time to time
  stop     // from rank 0: `everybody`, if all ranks are there
};

constexpr const char* everybody = "everybody";

// Sends and receives without waiting: to wait in MPI takes all the time of a processor, and takes
// forever where the other rank is lost. That a message cannot be sent is no error: a rank that is
// lost gives no sign of life, either.
class Mpi_mailbox {
public:
  struct Letter {
    int rank; // the sender, or to whom it is sent
    Mpi_message kind;
    std::string text;
  };

  explicit Mpi_mailbox(const boost::mpi::communicator& world) : world_(world) {}
  ~Mpi_mailbox() {
    for (auto& letter : sent_) // MPI may still read it
      static_cast<void>(letter.first.release());
  }
  Mpi_mailbox(const Mpi_mailbox&) = delete;
  Mpi_mailbox& operator=(const Mpi_mailbox&) = delete;

  std::optional<Letter> receive() {
    const auto status = world_.iprobe();
    if (!status)
      return std::nullopt;
    Letter letter{status->source(), static_cast<Mpi_message>(status->tag()), ""};
    letter.text.resize(static_cast<std::size_t>(status->count<char>().value_or(0)));
    world_.recv(letter.rank, letter.kind, letter.text.data(), static_cast<int>(letter.text.size()));
    return letter;
  }

  void send(Letter letter) {
    auto text = std::make_unique<std::string>(std::move(letter.text));
    try {
      auto request =
          world_.isend(letter.rank, letter.kind, text->data(), static_cast<int>(text->size()));
      sent_.emplace_back(std::move(text), std::move(request));
    } catch (const boost::mpi::exception&) {
    }
  }

  // Whether all that was sent is on its way; to be called from time to time.
  bool is_delivered() {
    sent_.remove_if([](auto& letter) {
      try {
        return letter.second.test().has_value();
      } catch (const boost::mpi::exception&) {
        return true;
      }
    });
    return sent_.empty();
  }

private:
  boost::mpi::communicator world_;
  std::list<std::pair<std::unique_ptr<std::string>, boost::mpi::request>> sent_;
};

// Tells when it is time again.
class Mpi_heartbeat {
public:
  using Clock = std::chrono::steady_clock;

  bool is_due() {
    if (Clock::now() - last_ < std::chrono::milliseconds(500))
      return false;
    last_ = Clock::now();
    return true;
  }

private:
  Clock::time_point last_ = Clock::now();
};

// Counts the seconds in which nothing is heard of a rank. Of the time for which this process itself
// is away, because it reads a large file or is stopped, one second counts: letters may be waiting.
class Mpi_silence {
public:
  using Clock = std::chrono::steady_clock;

  void end() {
    seconds_ = 0;
    asked_ = Clock::now();
  }
  // To be asked about twice a second or more often.
  double seconds() {
    const Clock::time_point now = Clock::now();
    seconds_ += (std::min)(std::chrono::duration<double>(now - asked_).count(), 1.0);
    asked_ = now;
    return seconds_;
  }

private:
  double seconds_ = 0;
  Clock::time_point asked_ = Clock::now();
};

inline void wait_a_little() {
  std::this_thread::sleep_for(std::chrono::microseconds(500));
}

} // namespace multipatch

#endif // MULTIPATCH_MPI_MESSAGES_H

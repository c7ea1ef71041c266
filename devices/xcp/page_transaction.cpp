#include "devices/xcp/page_transaction.h"

#include "control/base/assert.h"

#include <fmt/format.h>

#include <algorithm>

namespace halbench::devices::xcp {

namespace {

constexpr std::uint8_t Crc16Citt = 8;
constexpr double SwitchPatience_s = 0.5;
constexpr double SwitchPoll_s = 0.001;
constexpr int Tries = 2;
constexpr std::uint32_t MaxSegment = 1U << 20;

void putChange(Packet& image, const SegmentChange& change) {
    HB_ASSERT(change.offset + change.octets.size() <= image.size());
    std::copy(change.octets.begin(), change.octets.end(), image.begin() + change.offset);
}

SegmentChange markChange(const Packet& image, std::uint32_t source, std::uint32_t target, ByteOrder order) {
    const std::uint64_t number = readUnsigned(Octets(image).subspan(source, 4), order) + 1;
    SegmentChange change{target, {}};
    appendUnsigned(change.octets, number & 0xFFFFFFFFU, 4, order);
    return change;
}

/// Sorted and joined where they touch, so that few commands carry them.
std::vector<SegmentChange> joined(std::vector<SegmentChange> changes) {
    std::stable_sort(changes.begin(), changes.end(),
                     [](const SegmentChange& a, const SegmentChange& b) { return a.offset < b.offset; });
    std::vector<SegmentChange> result;
    for (SegmentChange& change : changes) {
        const bool touches =
            !result.empty() && result.back().offset + result.back().octets.size() == change.offset;
        if (touches) {
            result.back().octets.insert(result.back().octets.end(), change.octets.begin(),
                                        change.octets.end());
        } else {
            result.push_back(std::move(change));
        }
    }
    return result;
}

/// 0 or 1. Error: Protocol for any other.
Result<std::uint8_t> runningPage(XcpMaster& master, const A2lSegment& segment) {
    Result<std::uint8_t> running = master.page(PageAccess::ControlLoop, segment.number);
    if (running && (*running > 1 || segment.size > MaxSegment)) {
        return failure(
            ErrorCode::Protocol,
            fmt::format("the device uses page {} of a segment of {} bytes", *running, segment.size),
            "only pages 0 and 1 are supported; update the firmware");
    }
    return running;
}

/// One run of 3.10 with its intermediate results.
class Transaction {
public:
    Transaction(XcpMaster& master, XcpLink& link, const A2lSegment& segment)
        : m_master(&master), m_link(&link), m_segment(&segment) {}

    Result<void> prepare() {
        const Result<std::uint8_t> running = m_master->page(PageAccess::ControlLoop, m_segment->number);
        if (!running) {
            return failure(running.error());
        }
        if (*running > 1 || m_segment->size > MaxSegment) {
            return failure(
                ErrorCode::Protocol,
                fmt::format("the device uses page {} of a segment of {} bytes", *running, m_segment->size),
                "only pages 0 and 1 are supported; update the firmware");
        }
        m_idle = static_cast<std::uint8_t>(1 - *running);
        if (Result<void> done = m_master->setPage(PageAccess::Master, m_segment->number, m_idle); !done) {
            return done;
        }
        if (Result<void> done = copyRunning(*running); !done) {
            return done;
        }
        Result<Packet> image = m_master->read(m_segment->address, m_segment->size);
        if (!image) {
            return failure(image.error());
        }
        m_image = *std::move(image);
        return {};
    }

    /// Right after a switch the control loop may still be in the page it is about to leave.
    Result<void> copyRunning(std::uint8_t running) {
        const double end_s = m_link->transport().now_s() + SwitchPatience_s;
        for (;;) {
            const Result<bool> copied = m_master->copyPage(m_segment->number, running, m_idle);
            if (!copied) {
                return failure(copied.error());
            }
            if (*copied) {
                return {};
            }
            if (m_link->transport().now_s() >= end_s) {
                return failure(ErrorCode::DeviceRefused,
                               "the device does not release its inactive parameter page",
                               "check that the control loop is running; the old values are kept");
            }
            if (Result<void> pumped = m_link->pumpUntil(m_link->transport().now_s() + SwitchPoll_s);
                !pumped) {
                return pumped;
            }
        }
    }

    void apply(std::vector<SegmentChange> changes, const std::optional<TransactionMarks>& marks) {
        if (marks) {
            const ByteOrder order = m_master->session().order;
            changes.push_back(markChange(m_image, marks->first, marks->first, order));
            changes.push_back(markChange(m_image, marks->first, marks->last, order));
        }
        m_changes = joined(std::move(changes));
        for (const SegmentChange& change : m_changes) {
            putChange(m_image, change);
        }
    }

    Result<void> download() {
        for (const SegmentChange& change : m_changes) {
            const Address address{m_segment->address.offset + change.offset, m_segment->address.extension};
            if (Result<void> written = m_master->write(address, change.octets); !written) {
                return written;
            }
        }
        return {};
    }

    Result<bool> isVerified() {
        const auto checksum = m_master->checksum(m_segment->address, m_segment->size);
        if (!checksum) {
            return failure(checksum.error());
        }
        if (*checksum && (*checksum)->type == Crc16Citt) {
            return (*checksum)->checksum == crc16(m_image);
        }
        const auto place = firstDifference(); // other checksums say little: compare the octets themselves
        if (!place) {
            return failure(place.error());
        }
        return !*place;
    }

    Result<std::optional<PageMismatch>> firstDifference() {
        const Result<Packet> now = m_master->read(m_segment->address, m_segment->size);
        if (!now) {
            return failure(now.error());
        }
        const auto place = std::mismatch(now->begin(), now->end(), m_image.begin()).first;
        if (place == now->end()) {
            return std::optional<PageMismatch>{};
        }
        return std::optional<PageMismatch>(PageMismatch{static_cast<std::uint32_t>(place - now->begin())});
    }

    Result<void> switchOver() {
        if (Result<void> done = m_master->setPage(PageAccess::ControlLoop, m_segment->number, m_idle);
            !done) {
            return done;
        }
        // The control loop takes the page at the start of its next cycle.
        const double end_s = m_link->transport().now_s() + SwitchPatience_s;
        for (;;) {
            const Result<std::uint8_t> page = m_master->page(PageAccess::ControlLoop, m_segment->number);
            if (!page) {
                return failure(page.error());
            }
            if (*page == m_idle) {
                return {};
            }
            if (m_link->transport().now_s() >= end_s) {
                return failure(ErrorCode::DeviceRefused, "the device did not accept the new parameter set",
                               "check the state of the device; the old values are kept");
            }
            if (Result<void> pumped = m_link->pumpUntil(m_link->transport().now_s() + SwitchPoll_s);
                !pumped) {
                return pumped;
            }
        }
    }

private:
    XcpMaster* m_master;
    XcpLink* m_link;
    const A2lSegment* m_segment;
    std::uint8_t m_idle = 0;
    Packet m_image;
    std::vector<SegmentChange> m_changes;
};

Result<void> runTransaction(Transaction& transaction, const std::vector<SegmentChange>& changes,
                            const std::optional<TransactionMarks>& marks,
                            std::optional<PageMismatch>& mismatch) {
    if (Result<void> prepared = transaction.prepare(); !prepared) {
        return prepared;
    }
    transaction.apply(changes, marks);
    for (int attempt = 0; attempt < Tries; ++attempt) {
        if (Result<void> written = transaction.download(); !written) {
            return written;
        }
        const Result<bool> verified = transaction.isVerified();
        if (!verified) {
            return failure(verified.error());
        }
        if (*verified) {
            return transaction.switchOver();
        }
    }
    const auto place = transaction.firstDifference();
    if (!place) {
        return failure(place.error());
    }
    mismatch = *place;
    return failure(ErrorCode::DeviceRefused, "the values read back differ from those sent",
                   "the old values are kept; check the limits of the device");
}

} // namespace

Result<void> switchPages(XcpMaster& master, XcpLink& link, const A2lSegment& segment,
                         const std::vector<SegmentChange>& changes,
                         const std::optional<TransactionMarks>& marks,
                         std::optional<PageMismatch>& mismatch) {
    Transaction transaction(master, link, segment);
    Result<void> done = runTransaction(transaction, changes, marks, mismatch);
    if (!done && !link.lost()) {
        (void)readRunningPage(master, segment);
    }
    return done;
}

Result<void> readRunningPage(XcpMaster& master, const A2lSegment& segment) {
    const Result<std::uint8_t> running = runningPage(master, segment);
    if (!running) {
        return failure(running.error());
    }
    return master.setPage(PageAccess::Master, segment.number, *running);
}

} // namespace halbench::devices::xcp

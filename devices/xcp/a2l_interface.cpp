#include "devices/xcp/a2l_parser.h"

namespace halbench::devices::xcp {

// The parts of a description that belong to the protocol: IF_DATA XCP ... (3.13)

/// After `/begin IF_DATA`: true when it is ours; otherwise the block has been skipped.
bool A2lParser::entersXcp(const A2lToken& begin) {
    if (begin.text == "IF_DATA" && (m_lexer.peek().isWord("XCP") || m_lexer.peek().isWord("XCPplus"))) {
        m_lexer.take();
        return true;
    }
    m_lexer.skipBlock(begin);
    return false;
}

void A2lParser::moduleInterface(const A2lToken& begin) {
    if (!entersXcp(begin)) {
        return;
    }
    contents(
        begin,
        [this](const A2lToken& block) {
            if (block.text == "PROTOCOL_LAYER") {
                protocolLayer(block);
            } else if (block.text == "DAQ") {
                daq(block);
            } else {
                m_lexer.skipBlock(block);
            }
        },
        [](const std::string&) {});
}

void A2lParser::protocolLayer(const A2lToken& begin) {
    m_lexer.takeNumber("the protocol's version");
    const double timeout_ms = m_lexer.takeNumber("the answer time T1");
    if (timeout_ms > 0.0 && timeout_ms <= 60000.0) {
        m_description.answerTimeout_s = timeout_ms / 1000.0;
    }
    contents(
        begin, [this](const A2lToken& block) { m_lexer.skipBlock(block); }, [](const std::string&) {});
}

void A2lParser::daq(const A2lToken& begin) {
    contents(
        begin,
        [this](const A2lToken& block) { block.text == "EVENT" ? daqEvent(block) : m_lexer.skipBlock(block); },
        [](const std::string&) {});
}

void A2lParser::daqEvent(const A2lToken& begin) {
    A2lEvent event;
    event.name = m_lexer.takeString("the event's name");
    m_lexer.takeString("the event's short name");
    event.number = static_cast<std::uint16_t>(m_lexer.takeUnsigned("the event's number", 0xFFFF));
    m_lexer.takeWord("the event's direction");
    m_lexer.takeNumber("the event's number of lists");
    const std::uint64_t cycle = m_lexer.takeUnsigned("the event's cycle", 255);
    const std::size_t place = m_lexer.peek().place;
    const Result<double> unit =
        unitSeconds(static_cast<std::uint8_t>(m_lexer.takeUnsigned("the event's unit", 255)));
    if (unit) {
        event.cycle_s = *unit * static_cast<double>(cycle);
    } else if (cycle != 0) {
        m_lexer.fail(place, unit.error().message);
    }
    m_lexer.takeNumber("the event's priority");
    contents(
        begin, [this](const A2lToken& block) { m_lexer.skipBlock(block); }, [](const std::string&) {});
    m_description.events.push_back(std::move(event));
}

void A2lParser::segmentInterface(const A2lToken& begin, A2lSegment& segment) {
    if (!entersXcp(begin)) {
        return;
    }
    contents(
        begin,
        [&](const A2lToken& block) {
            block.text == "SEGMENT" ? segmentPages(block, segment) : m_lexer.skipBlock(block);
        },
        [](const std::string&) {});
}

void A2lParser::segmentPages(const A2lToken& begin, A2lSegment& segment) {
    segment.number = static_cast<std::uint8_t>(m_lexer.takeUnsigned("the segment's number", 255));
    m_lexer.takeUnsigned("the segment's number of pages", 255);
    segment.address.extension =
        static_cast<std::uint8_t>(m_lexer.takeUnsigned("the segment's address extension", 255));
    m_lexer.takeNumber("the segment's compression");
    m_lexer.takeNumber("the segment's encryption");
    contents(
        begin,
        [&](const A2lToken& block) {
            block.text == "PAGE" ? page(block, segment) : m_lexer.skipBlock(block);
        },
        [](const std::string&) {});
}

void A2lParser::page(const A2lToken& begin, A2lSegment& segment) {
    A2lPage page;
    page.number = static_cast<std::uint8_t>(m_lexer.takeUnsigned("the page's number", 255));
    m_lexer.takeWord("the page's control access");
    m_lexer.takeWord("the page's read access");
    const std::string write = m_lexer.takeWord("the page's write access");
    page.isWritable = write != "XCP_WRITE_ACCESS_NOT_ALLOWED";
    contents(
        begin, [this](const A2lToken& block) { m_lexer.skipBlock(block); }, [](const std::string&) {});
    segment.pages.push_back(page);
}

void A2lParser::measurementInterface(const A2lToken& begin, A2lMeasurement& measurement) {
    if (!entersXcp(begin)) {
        return;
    }
    contents(
        begin,
        [&](const A2lToken& block) {
            if (block.text != "DAQ_EVENT") {
                m_lexer.skipBlock(block);
                return;
            }
            eventList(block, measurement.events);
        },
        [](const std::string&) {});
}

void A2lParser::eventList(const A2lToken& begin, std::vector<std::uint16_t>& events) {
    // FIXED_EVENT_LIST EVENT n ... | VARIABLE, with blocks that list the available and the default events.
    // The default is one of the available ones, so it adds nothing.
    contents(
        begin,
        [&](const A2lToken& block) {
            if (block.text == "AVAILABLE_EVENT_LIST") {
                contents(
                    block, [this](const A2lToken& inner) { m_lexer.skipBlock(inner); },
                    [&](const std::string& word) {
                        if (word == "EVENT") {
                            events.push_back(
                                static_cast<std::uint16_t>(m_lexer.takeUnsigned("an event number", 0xFFFF)));
                        }
                    });
            } else {
                m_lexer.skipBlock(block);
            }
        },
        [&](const std::string& word) {
            if (word == "EVENT") {
                events.push_back(static_cast<std::uint16_t>(m_lexer.takeUnsigned("an event number", 0xFFFF)));
            }
        });
}

} // namespace halbench::devices::xcp

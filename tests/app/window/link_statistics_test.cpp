#include "tests/app/window/faulty_line.h"
#include "tests/app/window/window_test.h"
#include "widgets/controls/elided_label.h"

#include <QRegularExpression>

#include <chrono>
#include <cmath>
#include <optional>

namespace halbench::app {
namespace {

/// What the window says of its link, against what the line in between did.
class LinkStatisticsTest : public WindowTest {
protected:
    struct Said {
        double rate_Hz = 0.0;
        int lost = 0;
        int damaged = 0;
        double median_ms = 0.0;
        double worst_ms = 0.0;
    };

    void connectBoard(FaultyLine& line) {
        window->connectDevice(QString::fromStdString(line.uri()));
        ASSERT_TRUE(wait([&] { return session().state() == SessionState::Connected; }));
        ASSERT_TRUE(wait([&] { return window->bench().history().latest("hall.a").has_value(); }));
        ASSERT_TRUE(wait([&] { return said() && said()->rate_Hz > 0.0; })) << text().toStdString();
    }

    QString text() const {
        for (const auto* label : window->findChildren<widgets::ElidedLabel*>()) {
            if (label->accessibleName() == QLatin1String("Link statistics")) {
                return label->isVisible() ? label->words() : QString();
            }
        }
        return {};
    }

    std::optional<Said> said() const {
        static const QRegularExpression words(
            QStringLiteral("link: ([\\d.,]+) packets/s, (\\d+) lost, (\\d+) damaged, "
                           "([\\d.]+) ms \\(max. ([\\d.]+) ms\\)"));
        const QRegularExpressionMatch found = words.match(text());
        if (!found.hasMatch()) {
            return std::nullopt;
        }
        return Said{found.captured(1).remove(QLatin1Char(',')).toDouble(), found.captured(2).toInt(),
                    found.captured(3).toInt(), found.captured(4).toDouble(), found.captured(5).toDouble()};
    }
};

TEST_F(LinkStatisticsTest, whatTheLineLostAndDamagedIsCountedToTheLast) {
    open();
    FaultyLine line;
    connectBoard(line);
    const Said before = *said();
    line.loseSamples(7);
    ASSERT_TRUE(wait([&] { return line.lost() == 7; }));
    ASSERT_TRUE(wait([&] { return said() && said()->lost == before.lost + 7; })) << text().toStdString();
    EXPECT_EQ(said()->damaged, before.damaged); // what does not come cannot be damaged
    line.damageSamples(5);
    ASSERT_TRUE(wait([&] { return line.damaged() == 5; }));
    ASSERT_TRUE(wait([&] { return said() && said()->damaged == before.damaged + 5; }))
        << text().toStdString();
    EXPECT_EQ(said()->lost, before.lost + 7); // what came was not lost
    EXPECT_EQ(session().state(), SessionState::Connected);
}

TEST_F(LinkStatisticsTest, theRateIsThatOfTheStreamThatPassed) {
    open();
    FaultyLine line;
    connectBoard(line);
    const std::uint64_t samples = line.samples();
    const std::uint64_t messages = line.messages();
    ASSERT_TRUE(wait([&] { return line.samples() > samples + 1000; }));
    const double messagesPerSample =
        static_cast<double>(line.messages() - messages) / static_cast<double>(line.samples() - samples);
    // The board samples at 1 kHz and sends all that it samples at this rate; answers to commands come beside.
    const double expected_Hz = window->bench().liveSignals().rate_Hz() * messagesPerSample;
    // Packets are counted when they come, time when their block is complete: up to 20 ms of the half second
    // over which a rate is taken, and as much for answers that come in bunches.
    EXPECT_TRUE(wait([&] { return said() && std::abs(said()->rate_Hz / expected_Hz - 1.0) < 0.08; }))
        << text().toStdString() << " for " << expected_Hz;
}

TEST_F(LinkStatisticsTest, theAnswerTimeIsNotLessThanTheLineTook) {
    open();
    FaultyLine line;
    line.delay(std::chrono::milliseconds(15)); // the board itself answers within one or two
    connectBoard(line);
    EXPECT_GE(said()->median_ms, 15.0);
    EXPECT_LT(said()->median_ms, 500.0); // neither in seconds nor in microseconds
    EXPECT_GE(said()->worst_ms, said()->median_ms);
    EXPECT_EQ(said()->lost, 0);
}

TEST_F(LinkStatisticsTest, aSimulationHasNoLinkToSpeakOf) {
    open();
    connectMotor(1.0);
    EXPECT_EQ(text(), QString());
}

} // namespace
} // namespace halbench::app

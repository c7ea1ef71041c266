#include "app/workbench/wall_clock.h"

#include <QLocale>

#include <gtest/gtest.h>

#include <ctime>

namespace halbench::app {
namespace {

/// Who reads it lives eight hours east of Greenwich.
class WallClockTest : public testing::Test {
protected:
    WallClockTest() : m_zone(qgetenv("TZ")), m_locale(QLocale()) {
        qputenv("TZ", "EAST-8");
        tzset();
    }
    ~WallClockTest() override {
        m_zone.isNull() ? qunsetenv("TZ") : qputenv("TZ", m_zone);
        tzset();
        QLocale::setDefault(m_locale);
    }

private:
    QByteArray m_zone;
    QLocale m_locale;
};

TEST_F(WallClockTest, aDateIsReadOnTheReadersClockInTheReadersNotation) {
    QLocale::setDefault(QLocale("de_DE"));
    EXPECT_EQ(localDate("2026-11-22T20:11:05Z"), QStringLiteral("2026-11-23 04:11:05"));
    QLocale::setDefault(QLocale("en_GB"));
    EXPECT_EQ(localDate("2026-11-22T20:11:05Z"), QStringLiteral("2026-11-23 04:11:05"));
}

TEST_F(WallClockTest, whatIsNoDateStaysAsItIs) {
    EXPECT_EQ(localDate(""), QString());
    EXPECT_EQ(localDate("yesterday"), QStringLiteral("yesterday"));
}

} // namespace
} // namespace halbench::app

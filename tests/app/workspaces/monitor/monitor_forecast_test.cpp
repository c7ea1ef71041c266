#include "app/workspaces/monitor/monitor_forecast.h"
#include "devices/recording/recording_writer.h"
#include "tests/app/workspaces/monitor/monitor_fixture.h"
#include "widgets/controls/elided_label.h"

#include <QTemporaryDir>

#include <cmath>

namespace halbench::app {
namespace {

using Forecast = control::LimitForecast;

CoilForecast forecastOf(Forecast::Verdict verdict) {
    CoilForecast coil{"coil_temperature.a", {}};
    coil.forecast.verdict = verdict;
    coil.forecast.limit_degC = 80.0;
    return coil;
}

TEST(ForecastWords, sayWhatIsKnownAndWhatIsNot) {
    EXPECT_EQ(spanWords(119.0), "119 s");
    EXPECT_EQ(spanWords(150.0), "2.5 min");
    EXPECT_EQ(spanWords(9000.0), "2.5 h");
    CoilForecast reached = forecastOf(Forecast::Verdict::Reached);
    reached.forecast.time_s = 300.0;
    reached.forecast.interval95_s = {240.0, 366.0};
    reached.forecast.earliest_s = 240.0;
    EXPECT_EQ(forecastWords(reached),
              "Coil A reaches 80 °C at this load in 5.0 min (95 %: 4.0 min to 6.1 min).");
    CoilForecast never = forecastOf(Forecast::Verdict::NotReached);
    EXPECT_EQ(forecastWords(never), "Coil A stays below 80 °C at this load.");
    never.forecast.final95_degC = {48.25, 49.0};
    EXPECT_EQ(forecastWords(never), "Coil A stays below 80 °C at this load: final value 48.3 to 49.0 °C.");
    CoilForecast later = forecastOf(Forecast::Verdict::NotBefore);
    later.forecast.earliest_s = 90.0;
    EXPECT_EQ(forecastWords(later),
              "Coil A stays below 80 °C for 90 s at this load; final value not known yet.");
    EXPECT_EQ(forecastWords(forecastOf(Forecast::Verdict::AtLimit)), "Coil A is at its limit of 80 °C.");
    CoilForecast withheld = forecastOf(Forecast::Verdict::Withheld);
    withheld.forecast.reason = Forecast::Reason::TooShort;
    withheld.forecast.stretch_s = 12.0;
    EXPECT_EQ(forecastWords(withheld), "Time to 80 °C: needs 20 s of steady load (12 s so far).");
}

class MonitorForecastTest : public MonitorTest {
protected:
    /// Coil A at 3 A from 25 degC, B without current: T_a rises by 0.422 K/s at first and runs away slowly.
    void writeHeating(const QString& path) {
        Recording recording;
        recording.layout = std::make_shared<const StreamLayout>(StreamLayout{{{"coil_temperature.a", "degC"},
                                                                              {"coil_temperature.b", "degC"},
                                                                              {"current.a", "A"},
                                                                              {"current.b", "A"}},
                                                                             0.1});
        const double rate_per_s = (1.5 * 0.00393 * 9.0 - 1.0 / 15.0) / 32.0;
        for (int row = 0; row < 1200; ++row) {
            const double time_s = 0.1 * row;
            const double rise_K = 13.5 / 32.0 * std::expm1(rate_per_s * time_s) / rate_per_s;
            const double noise_K = 0.05 * std::sin(12.9898 * row * row); // deterministic, not a shape in time
            recording.time_s.push_back(time_s);
            recording.values.insert(recording.values.end(),
                                    {25.0 + rise_K + noise_K, 25.0 + noise_K, 3.0, 0.0});
        }
        devices::RecordingMeta meta;
        meta.device.model = "htm";
        meta.period_s = 0.1;
        meta.parameters = {{"limit.temperature", 80.0, "degC"}};
        for (const char* name : {"coil_temperature.a", "coil_temperature.b", "current.a", "current.b"}) {
            const bool isCurrent = std::string(name)[1] == 'u';
            const std::string unit = isCurrent ? "A" : "degC";
            meta.signals.push_back({name, devices::csvColumnName(name, unit), unit, name, {}});
        }
        ASSERT_TRUE(devices::writeExactRecordingFile(path.toStdString(), recording, meta));
    }
    QString words() {
        auto* label = find<widgets::ElidedLabel>(*panel, "Time until the coil limit is reached");
        return label->isVisible() ? label->words() : QString();
    }
    QTemporaryDir folder;
};

TEST_F(MonitorForecastTest, theLineBelowThePlotsTellsTheHotterCoilsTime) {
    EXPECT_EQ(words(), QString()) << "no device";
    writeHeating(folder.filePath("heat.csv"));
    connectTo("replay:" + folder.filePath("heat.csv"), 20.0);
    EXPECT_TRUE(wait([&] { return words().startsWith("Coil A reaches 80 °C at this load in "); }))
        << words().toStdString();
    // 25 to 80 degC at 3 A: ln(1 + rate 55/0.4219)/rate = 135 s from the start
    EXPECT_TRUE(words().contains(" s (95 %: ")) << words().toStdString();
    stack().setPlots({});
    EXPECT_TRUE(wait([&] { return words().isEmpty(); })) << "no plot of a temperature";
}

TEST_F(MonitorForecastTest, nothingIsSaidOfAMotorAtRest) {
    connectTo("sim:htm", 20.0);
    const auto seconds = [this] {
        const auto range = bench().history().range("coil_temperature.a");
        return range ? range->end_s - range->begin_s : 0.0;
    };
    ASSERT_TRUE(wait([&] { return seconds() > 60.0; })); // three times what the forecast needs
    EXPECT_EQ(words(), QString());
    session().disconnectDevice();
    EXPECT_TRUE(wait([&] { return words().isEmpty(); })) << "nothing is known of a device that is gone";
}

} // namespace
} // namespace halbench::app

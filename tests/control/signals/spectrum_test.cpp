#include "control/base/distributions.h"
#include "control/base/random.h"
#include "control/base/units.h"
#include "control/signals/segment_transform.h"
#include "control/signals/spectrum.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>

namespace halbench::control {
namespace {

constexpr double Period_s = 0.001;
constexpr double Nan = std::numeric_limits<double>::quiet_NaN();

struct Signal {
    std::vector<double> time_s;
    std::vector<double> values;

    SignalView view() const { return {time_s, values, "A"}; }
};

template <typename Function>
Signal sampled(std::size_t rows, const Function& value) {
    Signal signal;
    for (std::size_t row = 0; row < rows; ++row) {
        signal.time_s.push_back(static_cast<double>(row) * Period_s);
        signal.values.push_back(value(signal.time_s.back()));
    }
    return signal;
}

Signal sine(std::size_t rows, double amplitude, double frequency_Hz) {
    return sampled(rows, [=](double t) { return amplitude * std::sin(2.0 * Pi * frequency_Hz * t + 0.3); });
}

Signal whiteNoise(std::size_t rows, double sigma, std::uint64_t seed) {
    Random random(seed);
    return sampled(rows, [&](double) { return sigma * random.gaussian(); });
}

SpectrumConfig configOf(SpectrumScale scale, WindowShape window = WindowShape::Hann) {
    SpectrumConfig config;
    config.scale = scale;
    config.window = window;
    return config;
}

Spectrum computed(const Signal& signal, const SpectrumConfig& config) {
    const Result<Spectrum> result = spectrum(signal.view(), config);
    EXPECT_TRUE(result) << result.error().message;
    return result ? *result : Spectrum{};
}

TEST(SegmentTransform, agreesWithTheDefinitionAtEvenAndOddLengths) {
    for (const std::size_t length : {2U, 3U, 8U, 15U, 25U, 36U, 90U, 125U}) {
        const Signal noise = whiteNoise(length, 1.0, length);
        SegmentTransform transform(WindowShape::Rectangular, length, false);
        const std::vector<double>& powers = transform.powers(noise.values);
        ASSERT_EQ(powers.size(), length / 2 + 1);
        for (std::size_t k = 0; k < powers.size(); ++k) {
            std::complex<double> sum = 0.0;
            for (std::size_t n = 0; n < length; ++n) {
                sum += noise.values[n] *
                       std::polar(1.0, -2.0 * Pi * static_cast<double>(k * n) / static_cast<double>(length));
            }
            EXPECT_NEAR(powers[k], std::norm(sum), 1e-11 * static_cast<double>(length)) << length << " " << k;
        }
    }
}

TEST(SegmentTransform, fastLengthsAreTheNearestThatFit) {
    EXPECT_EQ(fastLength(1000, 5000), 1000U);
    EXPECT_EQ(fastLength(997, 5000), 1000U);
    EXPECT_EQ(fastLength(997, 999), 972U);
    EXPECT_EQ(fastLength(7, 100), 6U);
    EXPECT_EQ(fastLength(1, 1), 1U);
}

TEST(Spectrum, readsASineOnALineExactlyWithEveryWindow) {
    const Signal signal = sine(1000, 2.5, 50.0);
    for (const WindowFigures& window : windowFigures()) {
        const Spectrum peak = computed(signal, configOf(SpectrumScale::Peak, window.shape));
        const Spectrum rms = computed(signal, configOf(SpectrumScale::Rms, window.shape));
        ASSERT_EQ(peak.frequency_Hz.size(), 501U);
        EXPECT_NEAR(peak.frequency_Hz[50], 50.0, 1e-9);
        EXPECT_NEAR(peak.frequency_Hz[500], 500.0, 1e-9);
        EXPECT_NEAR(peak.values[50], 2.5, 1e-12) << window.name; // rounding
        EXPECT_NEAR(rms.values[50], 2.5 / std::sqrt(2.0), 1e-12) << window.name;
        EXPECT_NEAR(peak.values[50 + window.halfLobe_lines], 0.0, 1e-12) << window.name;
    }
}

TEST(Spectrum, aSineBetweenTwoLinesReadsLowByTheScallopingLoss) {
    const Signal signal = sine(10000, 1.0, 250.05);
    for (const WindowFigures& window : windowFigures()) {
        const Spectrum result = computed(signal, configOf(SpectrumScale::Peak, window.shape));
        // leakage of the line at the negative frequency, 5001 lines away: below 1e-4 for the slowest window
        EXPECT_NEAR(-20.0 * std::log10(result.values[2500]), window.scalloping_dB, 2e-3) << window.name;
    }
}

TEST(Spectrum, zeroAndHalfTheRateAreNotDoubled) {
    const Signal constant = sampled(1000, [](double) { return 3.0; });
    const Signal alternating = sampled(1000, [](double t) { return 2.0 * std::cos(Pi * t / Period_s); });
    for (const SpectrumScale scale : {SpectrumScale::Peak, SpectrumScale::Rms}) {
        SpectrumConfig config = configOf(scale);
        config.removesMean = false;
        EXPECT_NEAR(computed(constant, config).values[0], 3.0, 1e-12);
        EXPECT_NEAR(computed(alternating, config).values[500], 2.0, 1e-9);
    }
    EXPECT_NEAR(computed(constant, configOf(SpectrumScale::Peak)).values[0], 0.0, 1e-12);
}

TEST(Spectrum, integralOfTheDensityIsTheMeanSquare) {
    for (const std::size_t rows : {1000U, 1125U}) { // even and odd
        const Signal noise = whiteNoise(rows, 1.3, 7);
        SpectrumConfig config = configOf(SpectrumScale::Density, WindowShape::Rectangular);
        config.removesMean = false;
        config.segment_s = static_cast<double>(rows) * Period_s;
        const Spectrum result = computed(noise, config);
        ASSERT_EQ(result.segmentRows, rows);
        const double meanSquare =
            std::inner_product(noise.values.begin(), noise.values.end(), noise.values.begin(), 0.0) /
            static_cast<double>(rows);
        const double integral =
            std::accumulate(result.values.begin(), result.values.end(), 0.0) * result.lineDistance_Hz();
        EXPECT_NEAR(integral, meanSquare, 1e-12); // Parseval, up to rounding
        EXPECT_NEAR(result.rms, std::sqrt(meanSquare), 1e-12);
    }
}

TEST(Spectrum, aSineHasItsRmsWhateverTheWindow) {
    const Signal signal = sine(1000, 2.0, 50.0);
    for (const WindowFigures& window : windowFigures()) {
        const Spectrum result = computed(signal, configOf(SpectrumScale::Peak, window.shape));
        EXPECT_NEAR(result.rms, std::sqrt(2.0), 1e-12) << window.name;
    }
}

TEST(Spectrum, scalesFollowFromEachOther) {
    const Signal noise = whiteNoise(4000, 1.0, 3);
    SpectrumConfig config = configOf(SpectrumScale::Rms, WindowShape::BlackmanHarris);
    config.segment_s = 0.5;
    const Spectrum rms = computed(noise, config);
    config.scale = SpectrumScale::Peak;
    const Spectrum peak = computed(noise, config);
    config.scale = SpectrumScale::Density;
    const Spectrum density = computed(noise, config);
    config.scale = SpectrumScale::RootDensity;
    const Spectrum root = computed(noise, config);
    for (std::size_t line = 0; line < rms.values.size(); ++line) {
        const bool isEdge = line == 0 || line + 1 == rms.values.size();
        EXPECT_NEAR(peak.values[line], rms.values[line] * (isEdge ? 1.0 : std::sqrt(2.0)), 1e-12);
        EXPECT_NEAR(root.values[line], std::sqrt(density.values[line]), 1e-12);
        // the noise bandwidth in the table has five digits
        EXPECT_NEAR(density.values[line] * density.noiseBandwidth_Hz(), std::pow(rms.values[line], 2.0),
                    1e-5 * std::pow(rms.values[line], 2.0));
    }
}

TEST(Spectrum, whiteNoiseHasItsLevelWithinTheChiSquareInterval) {
    const double sigma = 0.7;
    const double level = 2.0 * sigma * sigma * Period_s;
    SpectrumConfig config = configOf(SpectrumScale::Density, WindowShape::Rectangular);
    config.segment_s = 0.1;
    config.overlap_ratio = 0.0;
    config.removesMean = false;
    const Spectrum result = computed(whiteNoise(20000, sigma, 11), config);
    ASSERT_EQ(result.segments, 200U);
    EXPECT_DOUBLE_EQ(result.equivalentAverages, 200.0);
    // Lines and segments are independent: the sum over the 49 inner lines is chi-square with 2 * 200 * 49
    // degrees. One in a million.
    const double freedom = 2.0 * 200.0 * 49.0;
    const double sum = std::accumulate(result.values.begin() + 1, result.values.end() - 1, 0.0);
    const double statistic = 2.0 * 200.0 * sum / level;
    EXPECT_GT(statistic, chiSquareQuantile(5e-7, freedom));
    EXPECT_LT(statistic, chiSquareQuantile(1.0 - 5e-7, freedom));
}

/// Share of independent lines whose interval holds the true level.
double coverage(const SpectrumConfig& config, std::size_t rows) {
    const double level = 2.0 * Period_s;
    int covered = 0;
    int lines = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const Spectrum result = computed(whiteNoise(rows, 1.0, seed), config);
        const std::size_t distance = 2 * figuresOf(config.window).halfLobe_lines; // neighbours share noise
        for (std::size_t line = distance; line + distance < result.values.size(); line += distance) {
            covered += result.low[line] <= level && level <= result.high[line] ? 1 : 0;
            ++lines;
        }
    }
    EXPECT_GT(lines, 900);
    return static_cast<double>(covered) / lines;
}

TEST(Spectrum, intervalsHoldTheTruthAsOftenAsTheySay) {
    const struct {
        WindowShape window;
        double overlap_ratio;
    } cases[] = {{WindowShape::Hann, 0.5},
                 {WindowShape::Hann, 0.75},
                 {WindowShape::BlackmanHarris, 0.75},
                 {WindowShape::Rectangular, 0.5}};
    for (const auto& test : cases) {
        SpectrumConfig config = configOf(SpectrumScale::Density, test.window);
        config.overlap_ratio = test.overlap_ratio;
        config.segment_s = 0.4;
        // 0.95 +- 0.007 for 900 lines; the equivalent chi-square of correlated segments is good to a percent
        EXPECT_NEAR(coverage(config, 4000), 0.95, 0.03) << figuresOf(test.window).name << test.overlap_ratio;
    }
}

TEST(Spectrum, halfOverlappingHannSegmentsCountAsTheLiteratureSays) {
    SpectrumConfig config = configOf(SpectrumScale::Density);
    config.segment_s = 0.1;
    const Spectrum result = computed(whiteNoise(1000, 1.0, 1), config);
    ASSERT_EQ(result.segments, 19U);
    // rho = 1/6 for half a segment, 0 beyond
    EXPECT_NEAR(result.equivalentAverages, 19.0 * 19.0 / (19.0 + 2.0 * 18.0 / 36.0), 1e-12);
}

TEST(Spectrum, noSegmentReachesAcrossAGapOrAMissingValue) {
    // The sine starts anew behind the gap, so that a segment across it would read another amplitude.
    Signal signal = sine(2500, 1.0, 50.0);
    for (std::size_t row = 1030; row < signal.time_s.size(); ++row) {
        signal.time_s[row] += 0.0173;
    }
    signal.values[2104] = Nan;
    SpectrumConfig config = configOf(SpectrumScale::Peak);
    config.segment_s = 0.5;
    const Spectrum result = computed(signal, config);
    EXPECT_NEAR(result.values[25], 1.0, 1e-12);
    EXPECT_EQ(result.segments, 3U + 3U); // of 1030, 1074 and 395 rows
    EXPECT_EQ(result.usedRows, 2000U);
    EXPECT_EQ(result.gaps, 1U);
    EXPECT_EQ(result.missingValues, 1U);
    // half overlapping ones are correlated within a stretch only
    EXPECT_NEAR(result.equivalentAverages, 36.0 / (6.0 + 2.0 * (2.0 + 2.0) / 36.0), 1e-12);
}

TEST(Spectrum, isRefusedWhenNoStretchIsAsLongAsASegment) {
    Signal signal = sine(1000, 1.0, 50.0);
    for (std::size_t row = 99; row < signal.values.size(); row += 100) {
        signal.values[row] = Nan;
    }
    SpectrumConfig config = configOf(SpectrumScale::Density);
    config.segment_s = 0.2;
    const Result<Spectrum> result = spectrum(signal.view(), config);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Refused);
    EXPECT_THAT(result.error().message, testing::HasSubstr("has 99 rows, 0.099 s"));
    EXPECT_THAT(result.error().hint, testing::HasSubstr("shorter segment"));
    for (std::size_t row = 0; row < signal.values.size(); row += 8) {
        signal.values[row] = Nan;
    }
    EXPECT_EQ(spectrum(signal.view(), configOf(SpectrumScale::Density)).error().code, ErrorCode::Refused);
}

TEST(Spectrum, aRateThatDriftsIsRefused) {
    Signal signal = sine(4000, 1.0, 50.0);
    for (std::size_t row = 2000; row < 4000; ++row) { // each step is even enough, all of them are not
        signal.time_s[row] = 2.0 + static_cast<double>(row - 2000) * 1.02 * Period_s;
    }
    SpectrumConfig config = configOf(SpectrumScale::Peak);
    const Result<Spectrum> result = spectrum(signal.view(), config);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::Refused);
    EXPECT_THAT(result.error().message, testing::HasSubstr("rate is not constant"));
    config.segment_s = 0.05; // 50 rows of it do not matter
    EXPECT_TRUE(spectrum(signal.view(), config));
}

TEST(Spectrum, withoutASegmentAmplitudesTakeAllAndDensitiesAverage) {
    const Signal signal = sine(4500, 1.0, 50.0);
    EXPECT_EQ(computed(signal, configOf(SpectrumScale::Peak)).segmentRows, 4500U);
    const Spectrum density = computed(signal, configOf(SpectrumScale::Density));
    EXPECT_EQ(density.segmentRows, 1000U);
    EXPECT_EQ(density.segments, 8U);
}

TEST(Spectrum, refusesSettingsThatAreNone) {
    const Signal signal = sine(1000, 1.0, 50.0);
    const auto codeOf = [&](auto change) {
        SpectrumConfig config;
        change(config);
        const Result<Spectrum> result = spectrum(signal.view(), config);
        return result ? ErrorCode::Internal : result.error().code;
    };
    EXPECT_EQ(codeOf([](SpectrumConfig& c) { c.overlap_ratio = 0.96; }), ErrorCode::OutOfRange);
    EXPECT_EQ(codeOf([](SpectrumConfig& c) { c.overlap_ratio = -0.1; }), ErrorCode::OutOfRange);
    EXPECT_EQ(codeOf([](SpectrumConfig& c) { c.overlap_ratio = Nan; }), ErrorCode::NotFinite);
    EXPECT_EQ(codeOf([](SpectrumConfig& c) { c.confidence_ratio = 1.0; }), ErrorCode::OutOfRange);
    EXPECT_EQ(codeOf([](SpectrumConfig& c) { c.confidence_ratio = 0.0; }), ErrorCode::OutOfRange);
    EXPECT_EQ(codeOf([](SpectrumConfig& c) { c.segment_s = 0.007; }), ErrorCode::OutOfRange);
    EXPECT_EQ(codeOf([](SpectrumConfig& c) { c.segment_s = -1.0; }), ErrorCode::OutOfRange);
    EXPECT_EQ(codeOf([](SpectrumConfig& c) { c.segment_s = Nan; }), ErrorCode::NotFinite);
    EXPECT_EQ(codeOf([](SpectrumConfig& c) { c.segment_s = 1e300; }), ErrorCode::Refused);
}

TEST(Spectrum, unitsFollowFromTheSignals) {
    EXPECT_EQ(spectrumUnit("A", SpectrumScale::Peak), "A");
    EXPECT_EQ(spectrumUnit("A", SpectrumScale::Rms), "A");
    EXPECT_EQ(spectrumUnit("A", SpectrumScale::Density), "A^2/Hz");
    EXPECT_EQ(spectrumUnit("A", SpectrumScale::RootDensity), "A/sqrt(Hz)");
    EXPECT_EQ(spectrumUnit("rad/s", SpectrumScale::Density), "(rad/s)^2/Hz");
    EXPECT_EQ(spectrumUnit("N*m", SpectrumScale::RootDensity), "(N*m)/sqrt(Hz)");
    EXPECT_EQ(spectrumUnit("", SpectrumScale::Density), "1/Hz");
    EXPECT_EQ(spectrumUnit("", SpectrumScale::RootDensity), "1/sqrt(Hz)");
    EXPECT_EQ(spectrumUnit("degC", SpectrumScale::Density), "K^2/Hz");
}

TEST(Spectrum, findsTheHighestPeaksOnce) {
    Signal signal = sine(4000, 1.0, 50.1); // its lobe spreads over several lines
    const Signal second = sine(4000, 3.0, 120.0);
    const Signal third = sine(4000, 0.2, 333.0);
    for (std::size_t row = 0; row < signal.values.size(); ++row) {
        signal.values[row] += 5.0 + second.values[row] + third.values[row];
    }
    for (const WindowShape window : {WindowShape::Hann, WindowShape::FlatTop}) {
        const Spectrum result = computed(signal, configOf(SpectrumScale::Peak, window));
        const std::vector<std::size_t> peaks = highestPeaks(result, 3);
        ASSERT_EQ(peaks.size(), 3U);
        EXPECT_NEAR(result.frequency_Hz[peaks[0]], 120.0, 1e-9);
        EXPECT_NEAR(result.frequency_Hz[peaks[1]], 50.0, 1e-9);
        EXPECT_NEAR(result.frequency_Hz[peaks[2]], 333.0, 1e-9);
    }
    const Spectrum pure = computed(second, configOf(SpectrumScale::Density));
    EXPECT_EQ(highestPeaks(pure, 10).size(), 1U); // the rest is rounding
    const Spectrum silence =
        computed(sampled(1000, [](double) { return 0.1; }), configOf(SpectrumScale::Peak));
    EXPECT_EQ(silence.rms, 0.0);
    EXPECT_TRUE(highestPeaks(silence, 10).empty());
}

TEST(Spectrum, endsWhenItIsTold) {
    const auto stop = [] { return Result<void>(failure(ErrorCode::Interrupted, "stopped")); };
    const Signal signal = sine(1000, 1.0, 50.0);
    EXPECT_EQ(spectrum(signal.view(), {}, stop).error().code, ErrorCode::Interrupted);
    EXPECT_EQ(spectrogram(signal.view(), {}, stop).error().code, ErrorCode::Interrupted);
}

TEST(Spectrogram, showsWhenAFrequencyChangesAndWhereAGapIs) {
    Signal signal =
        sampled(4000, [](double t) { return std::sin(2.0 * Pi * (t < 2.0 ? 100.0 : 200.0) * t); });
    for (std::size_t row = 3000; row < 4000; ++row) {
        signal.time_s[row] += 10.0;
    }
    SpectrumConfig config = configOf(SpectrumScale::Peak);
    config.segment_s = 0.2;
    const Result<Spectrogram> result = spectrogram(signal.view(), config);
    ASSERT_TRUE(result) << result.error().message;
    ASSERT_EQ(result->time_s.size(), 29U + 9U);
    ASSERT_EQ(result->frequency_Hz.size(), 101U);
    EXPECT_EQ(result->unit, "A");
    for (std::size_t segment = 0; segment < result->time_s.size(); ++segment) {
        const double middle_s = result->time_s[segment];
        if (std::fabs(middle_s - 2.0) < 0.11) {
            continue; // holds the change
        }
        EXPECT_NEAR(result->value(segment, 20), middle_s < 2.0 ? 1.0 : 0.0, 1e-9) << middle_s;
        EXPECT_NEAR(result->value(segment, 40), middle_s < 2.0 ? 0.0 : 1.0, 1e-9) << middle_s;
    }
    EXPECT_NEAR(result->time_s[0], 0.0995, 1e-12); // rows 0 to 199
    EXPECT_NEAR(result->time_s[1], 0.1995, 1e-12);
    EXPECT_NEAR(result->time_s[29], 13.0995, 1e-12); // behind the gap
}

TEST(Spectrogram, refusesWhatWouldFillTheMemory) {
    SpectrumConfig config;
    config.segment_s = 100.0;
    config.overlap_ratio = 0.95;
    const Result<Spectrogram> result = spectrogram(sine(5'200'000, 1.0, 50.0).view(), config);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, ErrorCode::OutOfRange);
}

} // namespace
} // namespace halbench::control

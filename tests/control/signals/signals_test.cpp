#include "control/base/units.h"
#include "control/signals/excitation.h"
#include "control/signals/window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>

namespace halbench::control {
namespace {

/// One line of the discrete Fourier transform, as an amplitude of a sine.
double lineAmplitude(const std::vector<double>& signal, std::size_t line) {
    std::complex<double> sum = 0.0;
    for (std::size_t i = 0; i < signal.size(); ++i) {
        sum += signal[i] * std::polar(1.0, -2.0 * Pi * static_cast<double>(line * i) /
                                               static_cast<double>(signal.size()));
    }
    return 2.0 * std::abs(sum) / static_cast<double>(signal.size());
}

TEST(Excitation, chirpCrossesZeroWhereItsPhaseDoes) {
    const auto signal = chirp({1e-4, 10.0}, 1.0, 5.0);
    ASSERT_TRUE(signal.has_value());
    int crossings = 0;
    for (std::size_t i = 1; i < signal->size(); ++i) {
        crossings += ((*signal)[i - 1] < 0.0) != ((*signal)[i] < 0.0) ? 1 : 0;
    }
    // Mean frequency 3 Hz for 10 s: 30 turns, two crossings each, the last one at the end itself.
    EXPECT_NEAR(crossings, 60, 1);
}

TEST(Excitation, multisineHasEqualLinesInItsBandAndNothingElsewhere) {
    const auto signal = multisine({0.01, 10.0}, 1.0, 10.0, 10);
    ASSERT_TRUE(signal.has_value());
    const double amplitude = lineAmplitude(*signal, 10);
    for (std::size_t line = 1; line < 500; ++line) {
        const bool isLine = line % 10 == 0 && line <= 100;
        EXPECT_NEAR(lineAmplitude(*signal, line), isLine ? amplitude : 0.0, 1e-12) << line;
    }
    EXPECT_DOUBLE_EQ(
        std::abs(*std::max_element(signal->begin(), signal->end(),
                                   [](double a, double b) { return std::abs(a) < std::abs(b); })),
        1.0);
}

// Schroeder's phases keep the crest factor near 1.7; in-phase cosines of 30 lines have sqrt(60) = 7.7.
TEST(Excitation, multisineHasALowCrestFactor) {
    const auto signal = multisine({0.001, 10.0}, 0.1, 3.0, 30);
    ASSERT_TRUE(signal.has_value());
    const double square = std::inner_product(signal->begin(), signal->end(), signal->begin(), 0.0);
    EXPECT_LT(1.0 / std::sqrt(square / static_cast<double>(signal->size())), 2.0);
}

TEST(Excitation, binarySequenceHasTheAutocorrelationOfAMaximumLengthSequence) {
    for (int stages = 2; stages <= 10; ++stages) {
        const auto signal = binarySequence(stages, 1);
        ASSERT_TRUE(signal.has_value());
        const std::size_t n = signal->size();
        ASSERT_EQ(n, (std::size_t{1} << stages) - 1);
        EXPECT_EQ(std::abs(std::accumulate(signal->begin(), signal->end(), 0.0)), 1.0);
        for (std::size_t shift = 1; shift < n; ++shift) {
            double sum = 0.0;
            for (std::size_t i = 0; i < n; ++i) {
                sum += (*signal)[i] * (*signal)[(i + shift) % n];
            }
            ASSERT_EQ(sum, -1.0) << stages << " stages, shift " << shift;
        }
    }
}

TEST(Excitation, theLongestRegistersRunThroughAllTheirStates) {
    for (int stages = 11; stages <= 16; ++stages) {
        const auto signal = binarySequence(stages, 1);
        ASSERT_TRUE(signal.has_value());
        // Of a maximum-length sequence half of all runs have length 1: 2^(stages-2) of 2^(stages-1).
        std::size_t runs = 0;
        for (std::size_t i = 0; i < signal->size(); ++i) {
            runs += (*signal)[i] != (*signal)[(i + 1) % signal->size()] ? 1U : 0U;
        }
        EXPECT_EQ(runs, std::size_t{1} << (stages - 1)) << stages;
        EXPECT_EQ(std::abs(std::accumulate(signal->begin(), signal->end(), 0.0)), 1.0);
    }
}

TEST(Excitation, holdsEachBitForTheAskedSamples) {
    const auto plain = binarySequence(5, 1);
    const auto held = binarySequence(5, 3);
    ASSERT_TRUE(plain.has_value() && held.has_value());
    for (std::size_t i = 0; i < held->size(); ++i) {
        EXPECT_EQ((*held)[i], (*plain)[i / 3]);
    }
}

TEST(Excitation, refusesWhatCannotBeSampled) {
    EXPECT_EQ(chirp({0.01, 1.0}, 1.0, 50.0).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(chirp({0.0, 1.0}, 1.0, 5.0).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(chirp({0.01, std::numeric_limits<double>::infinity()}, 1.0, 5.0).error().code,
              ErrorCode::NotFinite);
    EXPECT_EQ(multisine({0.01, 1.0}, 1.0, 3.0, 10).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(multisine({0.01, 1.0}, 1.0, 3.0, 0).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(binarySequence(1, 1).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(binarySequence(17, 1).error().code, ErrorCode::OutOfRange);
    EXPECT_EQ(binarySequence(5, 0).error().code, ErrorCode::OutOfRange);
}

// Harris (1978), table 1: coherent gain and equivalent noise bandwidth.
TEST(Window, hasTheFiguresOfTheLiterature) {
    const struct {
        WindowShape shape;
        double gain;
        double bandwidth;
    } cases[] = {{WindowShape::Rectangular, 1.0, 1.0},      {WindowShape::Hann, 0.5, 1.5},
                 {WindowShape::Hamming, 0.54, 1.36},        {WindowShape::Blackman, 0.42, 1.73},
                 {WindowShape::BlackmanHarris, 0.36, 2.00}, {WindowShape::FlatTop, 0.2156, 3.77}};
    for (const auto& expected : cases) {
        const auto weights = window(expected.shape, 1024);
        EXPECT_NEAR(coherentGain(weights), expected.gain, 0.005);
        EXPECT_NEAR(noiseBandwidth_lines(weights), expected.bandwidth, 0.005);
    }
}

TEST(Window, tableOfFiguresAgreesWithTheWeights) {
    for (const WindowFigures& figures : windowFigures()) {
        const auto weights = window(figures.shape, 4096);
        std::complex<double> betweenLines = 0.0;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            betweenLines += weights[i] * std::polar(1.0, -Pi * static_cast<double>(i) / 4096.0);
        }
        const double gain = coherentGain(weights);
        // the table has as many digits
        EXPECT_NEAR(gain, figures.coherentGain, 1e-8) << figures.name;
        EXPECT_NEAR(noiseBandwidth_lines(weights), figures.noiseBandwidth_lines, 1e-5) << figures.name;
        EXPECT_NEAR(-20.0 * std::log10(std::abs(betweenLines) / 4096.0 / gain), figures.scalloping_dB, 1e-4)
            << figures.name;
        for (std::size_t line = 1; line < 8; ++line) {
            EXPECT_EQ(lineAmplitude(weights, line) < 1e-9, line >= figures.halfLobe_lines)
                << figures.name << " " << line;
        }
        EXPECT_EQ(figuresOf(figures.shape).name, figures.name);
        EXPECT_EQ(findWindow(figures.name), figures.shape);
    }
    EXPECT_FALSE(findWindow("Hann"));
}

TEST(Window, readsTheAmplitudeOfASineBetweenTwoLines) {
    const std::size_t n = 1000;
    const auto weights = window(WindowShape::FlatTop, n);
    std::vector<double> signal(n);
    for (std::size_t i = 0; i < n; ++i) {
        signal[i] =
            3.0 * weights[i] * std::sin(2.0 * Pi * 50.5 * static_cast<double>(i) / static_cast<double>(n));
    }
    // The flat top window errs by less than 0.01 dB, 0.12 %, wherever the sine lies.
    EXPECT_NEAR(lineAmplitude(signal, 50) / coherentGain(weights), 3.0, 0.0012 * 3.0);
}

} // namespace
} // namespace halbench::control

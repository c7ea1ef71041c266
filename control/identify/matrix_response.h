#pragma once

#include "control/base/result.h"

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <vector>

namespace halbench::control {

/// Commands and positions of several axes while one experiment excites them periodically: whole periods, what
/// settles before them left out. One series of samples each.
struct MatrixExperiment {
    std::vector<std::vector<double>> inputs;
    std::vector<std::vector<double>> outputs;
};

/// As many experiments as inputs, each with the excitation on other axes or with other phases, so that every
/// input is excited at every line in at least one of them.
struct MatrixRows {
    double period_s = 1e-3;        ///< of the samples
    std::size_t rowsPerPeriod = 0; ///< M: one period of the excitation
    std::vector<int> lines;        ///< excited multiples of 1/(M period_s), ascending, below M/2
    std::vector<MatrixExperiment> experiments;
};

/// A plant of several inputs and outputs at one frequency.
struct MatrixPoint {
    double frequency_rad_s = 0.0;
    Eigen::MatrixXcd value;    ///< G, outputs x inputs
    Eigen::MatrixXd radius;    ///< 95 % circle of each entry, of what scatters between the periods
    Eigen::VectorXd coherence; ///< multiple coherence of each output with all inputs, of one period
    Eigen::MatrixXcd scatter;  ///< covariance of the mean equation error of one experiment
    Eigen::MatrixXcd inverse;  ///< U^-1, experiments x inputs
    int averages = 0;          ///< periods of one experiment
    double freedom = 0.0;      ///< degrees of freedom of the scatter, two for each complex number
};

/// With U, Y the Fourier coefficients of all inputs and outputs, averaged over the P periods, one column an
/// experiment, and U_p, Y_p those of the p-th period:
///
///     G = Y U^-1,    E_p = Y_p - G U_p,    S = sum E_p E_p^H / (n (P - 1))
///
/// Noise that the loop carries back into U has no mean over synchronous periods, so that it biases G by the
/// order 1/P of its own power only (Pintelon and Schoukens 2012, sections 2.7 and 7.2.7). G_ij is within the
/// circle
///
///     |error|^2 <= F(2, 2 n (P - 1)) S_ii/P sum_e |(U^-1)_ej|^2
///
/// with 95 %. The multiple coherence is 1 - sum |E_p|^2/sum |Y_p|^2 with the freedom of the fit counted. A
/// drift, which the means of the periods show, is taken out first. Help: resources/help/identification.md.
/// Errors: InvalidInput (lengths, fewer than four periods, lines, experiments), NotFinite, Refused (an input
/// that was not excited on its own).
Result<std::vector<MatrixPoint>> estimateMatrix(const MatrixRows& rows);

/// 95 % radius of left^T G right where G scatters as its point tells and the two vectors are known.
double scatterRadius(const MatrixPoint& point, const Eigen::VectorXcd& left, const Eigen::VectorXcd& right);

} // namespace halbench::control

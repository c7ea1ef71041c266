#pragma once

#include "app/procedures/apply/apply_procedure.h"
#include "app/procedures/tune/tune.h"
#include "app/workbench/display_quantity.h"

#include <QTableWidget>

#include <optional>
#include <vector>

namespace halbench::app {

/// One predicted figure: of the proposed gains and of those on the device.
struct TuneNumber {
    QString name;
    QString proposed;
    QString interval; ///< of 5 % to 95 % of the motors that the data allow
    QString present;
    QString help;
};
/// Stability, margins with their robust bounds, friction band, steps; for those who read numbers.
std::vector<TuneNumber> tuneNumbers(const TuneResult& proposed, const std::optional<AnalysisResult>& present,
                                    const DisplayUnits& units);

/// The large step that is predicted, in the panel's words too.
constexpr double LargeStep_rad = 1.7453292519943295; ///< 100 degrees

/// What Apply and verify does to the rotor, before it is pressed.
QString verificationWords(const MoveOutlook& outlook, const DisplayUnits& units);
/// The same of an apply in small steps, of which `outlook` is one.
QString liveStepWords(const MoveOutlook& outlook, const DisplayUnits& units);

/// How far a verification step was from what the prediction allows, in one sentence.
QString agreementWords(const VerificationBand& band, const MoveFigures& measured, const DisplayUnits& units);

/// These numbers as a table that is only read.
class TuneNumbers : public QTableWidget {
    Q_OBJECT
public:
    explicit TuneNumbers(QWidget* parent = nullptr);
    void setNumbers(const std::vector<TuneNumber>& numbers);
    /// The present gains are those from before an apply that is neither kept nor restored yet.
    void setUndecided(bool isUndecided);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void refreshWords();

    bool m_isUndecided = false;
};

} // namespace halbench::app

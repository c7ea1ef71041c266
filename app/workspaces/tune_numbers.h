#pragma once

#include "app/procedures/tune.h"

#include <QTableWidget>

#include <optional>
#include <vector>

namespace halbench::app {

/// One predicted figure: of the proposed gains and of those on the device.
struct TuneNumber {
    QString name;
    QString proposed;
    QString present;
    QString help;
};
/// Stability, margins with their robust bounds, friction band, steps; for those who read numbers.
std::vector<TuneNumber> tuneNumbers(const TuneResult& proposed, const std::optional<AnalysisResult>& present);

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

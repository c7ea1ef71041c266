#pragma once

#include "app/procedures/tune/tune.h"
#include "app/workbench/display_quantity.h"

#include <QWidget>

#include <optional>
#include <string>
#include <vector>

class QPushButton;
class QTableWidget;

namespace halbench::app {

/// A design as the comparison shows it.
struct ComparedDesign {
    std::string name; ///< of a kept one
    std::string method;
    std::optional<control::PidGains> gains;  ///< parallel, per radian; nothing: its document cannot be read
    std::optional<AnalysisResult> predicted; ///< nothing: not yet, or not with this motor
    std::optional<double> bandwidth_rad_s;   ///< of the closed loop
    bool isDrawn = false;
    QString reason;          ///< why nothing is predicted
    bool isFiltered = false; ///< with weights or filters
};

/// Designs side by side: gains, margins, bandwidth, overshoot. The first row is the one that is worked on;
/// those below are kept under their names, drawn in the pictures when ticked, taken up again, renamed (F2)
/// or removed (Del). Only shows and asks. Thread: GUI.
class DesignTable : public QWidget {
    Q_OBJECT
public:
    explicit DesignTable(QWidget* parent = nullptr);

    /// `proposed` is absent while nothing is worked on.
    void setDesigns(const std::optional<ComparedDesign>& proposed, const std::vector<ComparedDesign>& kept,
                    const DisplayUnits& units);
    void setHistory(bool canUndo, bool canRedo);
    void editName(int kept); ///< begins to

Q_SIGNALS:
    void keepRequested(); ///< of what is proposed
    void takeUpRequested(int kept);
    void removeRequested(int kept);
    void renameRequested(int kept, const QString& name);
    void drawRequested(int kept, bool isDrawn);
    void undoRequested();
    void redoRequested();

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refreshWords();
    void refreshButtons();
    void fillRow(int row, const ComparedDesign& design, bool isKept);
    void fillFigures(int row, const ComparedDesign& design);
    void sayReason(int row, const QString& reason);
    void setText(int row, int column, const QString& text);
    int currentKept() const; ///< -1: none

    QTableWidget* m_table = nullptr;
    QPushButton* m_keep = nullptr;
    QPushButton* m_takeUp = nullptr;
    QPushButton* m_remove = nullptr;
    QPushButton* m_undo = nullptr;
    QPushButton* m_redo = nullptr;
    DisplayUnits m_units;
    bool m_hasProposed = false;
    bool m_isFilling = false;
};

} // namespace halbench::app

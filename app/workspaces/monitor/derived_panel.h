#pragma once

#include "app/workbench/workbench.h"

#include <QWidget>

class QHBoxLayout;
class QMenu;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace halbench::app {

class ExpressionEdit;

/// Signals computed from those of the device by an expression; once kept they are in the tree of signals
/// (resources/help/monitor.md, "Derived signals").
class DerivedPanel : public QWidget {
    Q_OBJECT

public:
    explicit DerivedPanel(Workbench& bench, QWidget* parent = nullptr);

Q_SIGNALS:
    void plotRequested(const QString& name, bool isPlotted); ///< of a signal that was added

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    QWidget* buildFields();
    void addField(QLineEdit* field, const QString& title, const QString& toolTip, int characters,
                  QHBoxLayout& row);
    void buildEmpty();
    void fillInsertMenu();
    void takeWords();
    devices::DerivedSignal typed() const;
    void check();
    void keep();
    void remove();
    void edit(int row);
    void showList();

    Workbench& m_bench;
    QLineEdit* m_name = nullptr;
    ExpressionEdit* m_expression = nullptr;
    QLineEdit* m_unit = nullptr;
    QPushButton* m_keep = nullptr;
    QPushButton* m_remove = nullptr;
    QLabel* m_problem = nullptr;
    QTableWidget* m_list = nullptr;
    QLabel* m_empty = nullptr;
    QMenu* m_insert = nullptr;
};

} // namespace halbench::app

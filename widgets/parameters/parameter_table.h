#pragma once

#include "control/base/parameter_spec.h"
#include "widgets/parameters/parameter_table_model.h"

#include <QWidget>

#include <optional>
#include <string>
#include <vector>

class QAction;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTreeView;

namespace halbench::widgets {

class MessageBar;
class ParameterFilterModel;

/// The parameters of a device with search, changed-only filter, help and undo. It writes nothing itself: the
/// owner answers the signals and reports back through model().setDeviceValues().
class ParameterTable : public QWidget {
    Q_OBJECT
public:
    explicit ParameterTable(QWidget* parent = nullptr);
    ~ParameterTable() override;

    ParameterTableModel& model() { return *m_model; }
    void setSpecs(std::vector<ParameterSpec> specs);
    void setOnline(bool isOnline); ///< without a device nothing can be read or written; values are stale
    void setSearch(const QString& words);
    /// Of what is shown and typed, until the user chooses another here.
    void setAngleUnit(AngleUnit unit);
    MessageBar& messages() { return *m_messages; } ///< for refusals of the device

Q_SIGNALS:
    void writeRequested(const std::vector<halbench::ParameterValue>& changed);
    void readRequested();
    void changedCountChanged(int count);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void createActions();
    QAction* addAction(const char* icon, const char* key);
    void createView();
    void write();
    void layOut();
    void fitColumns();
    int numberWidth(int column) const;
    void connectModel();
    void onEditRefused(const QString& name, const QString& message, const QString& remedy,
                       std::optional<double> suggestion);
    void onAngleUnitChosen(int index);
    void showHelp();
    void retranslate();
    void refreshActions();
    QString helpText(const ParameterSpec& spec) const;

    ParameterTableModel* m_model = nullptr;
    ParameterFilterModel* m_filter = nullptr;
    QLineEdit* m_search = nullptr;
    QPushButton* m_changedOnly = nullptr;
    QComboBox* m_angleUnit = nullptr;
    QTreeView* m_view = nullptr;
    MessageBar* m_messages = nullptr;
    QLabel* m_help = nullptr;
    QPushButton* m_writeButton = nullptr;
    QAction* m_write = nullptr;
    QAction* m_read = nullptr;
    QAction* m_revert = nullptr;
    QAction* m_defaults = nullptr;
    QAction* m_undo = nullptr;
    QAction* m_redo = nullptr;
    QAction* m_find = nullptr;
    std::string m_refusedName;
    std::optional<double> m_suggestion;
    bool m_isOnline = false;
    bool m_hasFittedColumns = false;
    bool m_isFitting = false;
    bool m_isWidthChosen = false; ///< of a column, by the user
};

} // namespace halbench::widgets

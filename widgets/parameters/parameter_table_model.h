#pragma once

#include "control/base/parameter_spec.h"
#include "widgets/language/display_units.h"

#include <QAbstractItemModel>
#include <QString>
#include <QUndoStack>

#include <optional>
#include <utility>
#include <vector>

namespace halbench::widgets {

/// The parameters of a device in groups: the value on the device, the one edited here, the default. Edits
/// stay here until the owner writes `changedValues()` and reports what the device then holds; every edit can
/// be undone, also after it was written (undo then makes an edit of it). Values are SI inside; only what is
/// shown turns with the angle unit.
class ParameterTableModel : public QAbstractItemModel {
    Q_OBJECT
public:
    enum Column { NameColumn, DeviceColumn, EditedColumn, UnitColumn, DefaultColumn, MinColumn, MaxColumn };
    static constexpr int Columns = MaxColumn + 1;
    enum DataRole {
        NameRole = Qt::UserRole, ///< of the parameter; empty for a group
        ChangedRole,             ///< bool: edited and not on the device yet
        OutsideRole,             ///< bool: the device's value changed behind our back
        SearchRole,              ///< words to search in
        ChoicesRole              ///< QStringList of an enumeration
    };
    enum class Origin {
        Read,   ///< differences to what was known come from outside
        Written ///< read back after our own write
    };

    explicit ParameterTableModel(QObject* parent = nullptr);

    void setSpecs(std::vector<ParameterSpec> specs); ///< forgets values, edits and undo
    void setDeviceValues(const std::vector<ParameterValue>& values, Origin origin);
    void setStale(bool isStale); ///< the device is gone: its values are the last ones known
    void setAngleUnit(AngleUnit unit);
    AngleUnit angleUnit() const { return m_angleUnit; }

    std::vector<ParameterValue> changedValues() const;
    int changedCount() const;

    /// Errors: UnknownName and those of checkParameterValue; then `editRefused` was sent too.
    Result<void> edit(const std::string& name, double value);
    void revert() override; ///< edits become what the device holds; undoable in one step
    void editToDefaults();  ///< every writable value, undoable in one step
    void acknowledgeOutsideChanges();
    QUndoStack& undoStack() { return m_undo; }

    const ParameterSpec* specAt(const QModelIndex& index) const; ///< nullptr for a group
    QModelIndex indexOf(const std::string& name) const;          ///< its edited cell

    QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    QModelIndex parent(const QModelIndex& index) const override;
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

Q_SIGNALS:
    void changedCountChanged(int count);
    /// A value that may not be; `suggestion` is the nearest allowed one (SI) if there is one.
    void editRefused(const QString& name, const QString& message, const QString& remedy,
                     std::optional<double> suggestion);

private:
    friend class ParameterEditCommand;
    struct Row {
        ParameterSpec spec;
        std::optional<double> device;
        std::optional<double> edited;
        std::optional<double> beforeOutsideChange;
    };
    struct Group {
        QString title;
        std::vector<std::size_t> rows;
    };

    struct Change {
        std::size_t row;
        std::optional<double> before, after; ///< what is shown as edited
    };

    const Row* rowAt(const QModelIndex& index) const;
    std::optional<std::size_t> findRow(const std::string& name) const;
    Result<void> editRow(std::size_t row, std::optional<double> value, const QString& typed);
    void refuse(const Row& row, const Error& error, const QString& typed, std::optional<double> value);
    void push(std::vector<Change> changes, const QString& text);
    void show(std::size_t row, std::optional<double> value);
    void announce(std::size_t row);
    void announceCount();
    enum class Digits { All, Few };
    QString shownValue(const Row& row, std::optional<double> value, Digits digits = Digits::All) const;
    QString cellText(const Row& row, int column) const;
    QString toolTip(const Row& row, int column) const;
    QVariant groupData(const Group& group, int column, int role) const;
    QVariant look(const Row& row, int column, int role) const;

    std::vector<Row> m_rows;
    std::vector<Group> m_groups;
    QUndoStack m_undo;
    AngleUnit m_angleUnit = AngleUnit::Radian;
    bool m_isStale = false;
    int m_announcedCount = 0;
};

/// The words of an enumeration or a switch; empty for a number.
QStringList choicesOf(const ParameterSpec& spec);

} // namespace halbench::widgets

#pragma once

#include <QSortFilterProxyModel>

namespace halbench::widgets {

/// Parameters whose name, group, help or unit contain every word of the search; a group stays while one of
/// its parameters does.
class ParameterFilterModel : public QSortFilterProxyModel {
    Q_OBJECT
public:
    explicit ParameterFilterModel(QObject* parent = nullptr);

    void setSearch(const QString& words);
    void setChangedOnly(bool isChangedOnly); ///< edited here or changed outside

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    QStringList m_words;
    bool m_isChangedOnly = false;
};

} // namespace halbench::widgets

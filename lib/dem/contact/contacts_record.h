// Converts contacts to and from records.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/contact/contacts.h"
#include "dem/state/bodies.h"
#include "dem/state/cell.h"
#include "dem/state/plane.h"

namespace soilweave::dem {

/// Returns all touching pairs, planes included, with their history, sorted by bodies.
io::ContactsRecord contacts_record(const Contacts& contacts, const Bodies& bodies, const Cell& cell,
                                   const Planes& planes);

/// Lists the pairs of a record, in any order, with their history.
void list_recorded(const io::ContactsRecord& record, Bodies& bodies, Contacts& contacts);

}  // namespace soilweave::dem

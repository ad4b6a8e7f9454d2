/* Made from VERSION by tools/tables/registers.py; changes here are lost.
 * The version of library and core that this header belongs to; hwffd_version() and
 * the register VERSION have those that run.
 * SPDX-License-Identifier: Apache-2.0 */
#ifndef HWFFD_VERSION_H
#define HWFFD_VERSION_H

#define HWFFD_VERSION_MAJOR 0
#define HWFFD_VERSION_MINOR 3
#define HWFFD_VERSION_PATCH 0
#define HWFFD_VERSION "0.3.0"

/* One number that grows with the version: 10203 is 1.2.3. */
#define HWFFD_VERSION_NUMBER 300
/* Whether the headers are of that version or a later one, in #if too. */
#define HWFFD_VERSION_AT_LEAST(major, minor, patch) \
  (HWFFD_VERSION_NUMBER >= (major)*10000 + (minor)*100 + (patch))

#endif

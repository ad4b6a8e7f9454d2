/* Made from VERSION by scripts/registers.py; changes here are lost.
 * The version of library and core that this header belongs to; hwffd_version() and
 * the register VERSION have those that run.
 * SPDX-License-Identifier: Apache-2.0 */
#ifndef HWFFD_VERSION_H
#define HWFFD_VERSION_H

#define HWFFD_VERSION_MAJOR 0
#define HWFFD_VERSION_MINOR 2
#define HWFFD_VERSION_PATCH 0
#define HWFFD_VERSION "0.2.0"

#endif

// What a model includes is compiled for this file, and then there for all (HwffdVerilate.cmake).
// SPDX-License-Identifier: Apache-2.0

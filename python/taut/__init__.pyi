# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT

from taut import gp as gp
from taut import gradients as gradients
from taut import notebook as notebook
from taut import plot as plot
from taut._taut import *  # noqa: F403
from taut.page import app as app
from taut.surveys import read_survey as read_survey

__version__: str

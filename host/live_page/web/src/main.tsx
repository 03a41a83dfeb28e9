// SPDX-License-Identifier: MIT
import './page.css';
import { render } from 'preact';
import { startControls } from './drive/controls';
import { session } from './session';
import { App } from './shell/app';
import { exposeTestInterface } from './test_interface';
import { startTheme } from './theme';

startTheme();
exposeTestInterface(session);
startControls(session);
render(<App session={session} />, document.getElementById('app')!);
session.start();

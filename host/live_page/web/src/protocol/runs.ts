// SPDX-License-Identifier: MIT

export interface RunEntry {
  id: string;
  name: string;
  live: boolean;
  finished: boolean;
}

export interface RunFile {
  name: string;
  bytes: number;
  media_type: string;
}

async function get(path: string): Promise<Response> {
  const response = await fetch(path);
  if (!response.ok) throw new Error(`${path}: ${response.status}`);
  return response;
}

export async function fetchRuns(): Promise<RunEntry[]> {
  return (await (await get('api/v1/runs')).json()) as RunEntry[];
}

export async function fetchFiles(run: string): Promise<RunFile[]> {
  return (await (await get(`api/v1/runs/${encodeURIComponent(run)}/files`)).json()) as RunFile[];
}

export function fileUrl(run: string, name: string): string {
  return `api/v1/runs/${encodeURIComponent(run)}/files/${encodeURIComponent(name)}`;
}

export async function fetchHistory(run: string): Promise<ArrayBuffer> {
  return (await get(`api/v1/runs/${encodeURIComponent(run)}/history`)).arrayBuffer();
}
